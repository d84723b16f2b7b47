#include "tools/search/trial_watch.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::search {
namespace {

constexpr double kNsPerS = 1e9;
constexpr double kNoticedMoveM = 0.01;
constexpr double kNoticedRiseM = 0.003;

/// Heading of a body: rotation about the vertical of its x axis.
double yaw_of(const scarab_Pose& pose) {
  const auto& q = pose.orientation_wxyz;
  return std::atan2(2 * (q[0] * q[3] + q[1] * q[2]), 1 - 2 * (q[2] * q[2] + q[3] * q[3]));
}

bool is_leg(scarab_Solid solid) {
  return solid == scarab_SOLID_COXA || solid == scarab_SOLID_FEMUR || solid == scarab_SOLID_TIBIA ||
         solid == scarab_SOLID_FOOT;
}

bool is_robot_on_object(const scarab_Contact& contact) {
  const auto is_robot = [](scarab_Solid solid) {
    return solid == scarab_SOLID_TRUNK || is_leg(solid);
  };
  return (contact.solid_a == scarab_SOLID_OBJECT && is_robot(contact.solid_b)) ||
         (contact.solid_b == scarab_SOLID_OBJECT && is_robot(contact.solid_a));
}

/// Parts that are to push nothing: an object that lies on them is carried.
bool is_smooth(scarab_Solid solid) {
  return solid == scarab_SOLID_TRUNK || solid == scarab_SOLID_COXA || solid == scarab_SOLID_FEMUR;
}

double lifted_n(const scarab_Contact& contact) {
  if (contact.solid_b == scarab_SOLID_OBJECT && is_smooth(contact.solid_a)) {
    return contact.force_n[2];
  }
  if (contact.solid_a == scarab_SOLID_OBJECT && is_smooth(contact.solid_b)) {
    return -contact.force_n[2];
  }
  return 0;
}

}  // namespace

TrialWatch::TrialWatch(const Scenario& scenario, const plant::PlantConfig& plant, double give_up_s)
    : scenario_(scenario),
      across_margin_m_(plant.referee.across_margin_m),
      object_weight_n_(plant.gravity_m_s2 * (scenario.object_mass_kg > 0 ? scenario.object_mass_kg
                                                                         : plant.object.mass_kg)),
      give_up_s_(give_up_s) {}

void TrialWatch::see(const scarab_WorldState& world) {
  if (!start_) {
    start_ = Start{world.trunk.position_m[0], world.trunk.position_m[1], yaw_of(world.trunk),
                   world.object.position_m[0], world.object.position_m[2]};
    last_yaw_rad_ = start_->yaw_rad;
  }
  measure_.time_s = static_cast<double>(world.header.sim_time_ns) / kNsPerS;
  measure_.progress = std::max(measure_.progress, std::clamp(way_share(world), 0.0, 1.0));
  follow_heading(world);
  follow_contacts(world);
  follow_motion(world);
  if (world.verdict == scarab_VERDICT_OPEN) return;
  measure_.success = world.verdict == scarab_VERDICT_SUCCESS;
  measure_.time_s = world.verdict_time_s;
  measure_.reason = world.verdict_reason;
}

void TrialWatch::see(const scarab_Behaviour& behaviour) {
  if (touched_ || behaviour.state != scarab_BEHAVIOUR_APPROACH) return;
  measure_.approach_pitch_rad = std::max(measure_.approach_pitch_rad, std::abs(behaviour.bs_rad));
}

bool TrialWatch::stuck() const { return measure_.time_s - moved_time_s_ > give_up_s_; }

Measure TrialWatch::measure() const {
  Measure result = measure_;
  const double samples = std::max(1U, samples_);
  result.leg_leg_share = leg_leg_samples_ / samples;
  result.carry_share = carried_ / samples;
  if (result.reason.empty() && stuck()) result.reason = "nothing moves any more";
  return result;
}

double TrialWatch::way_share(const scarab_WorldState& world) const {
  switch (scenario_.goal) {
    case Goal::kAcross: {
      const double whole_m = start_->object_x - (world.obstacle_x_m - across_margin_m_);
      return world.object_travel_m / whole_m;
    }
    case Goal::kTravel:
      return world.object_travel_m / scenario_.distance_m;
    case Goal::kWalk:
      return std::hypot(world.trunk.position_m[0] - start_->trunk_x,
                        world.trunk.position_m[1] - start_->trunk_y) /
             scenario_.distance_m;
    case Goal::kNone:
      break;
  }
  return measure_.time_s / scenario_.time_limit_s;
}

void TrialWatch::follow_heading(const scarab_WorldState& world) {
  const double yaw_rad = yaw_of(world.trunk);
  turned_rad_ += std::remainder(yaw_rad - last_yaw_rad_, 2 * M_PI);
  last_yaw_rad_ = yaw_rad;
  measure_.heading_max_rad = std::max(measure_.heading_max_rad, std::abs(turned_rad_));
}

void TrialWatch::follow_contacts(const scarab_WorldState& world) {
  ++samples_;
  bool legs_touch = false;
  double lifted = 0;
  for (std::uint32_t i = 0; i < world.contacts._length; ++i) {
    const scarab_Contact& contact = world.contacts._buffer[i];
    legs_touch = legs_touch || (is_leg(contact.solid_a) && is_leg(contact.solid_b));
    lifted += lifted_n(contact);
    touched_ = touched_ || is_robot_on_object(contact);
  }
  if (legs_touch) ++leg_leg_samples_;
  carried_ += std::max(0.0, lifted) / object_weight_n_;
}

void TrialWatch::follow_motion(const scarab_WorldState& world) {
  trunk_way_m_ = std::max(trunk_way_m_, std::hypot(world.trunk.position_m[0] - start_->trunk_x,
                                                   world.trunk.position_m[1] - start_->trunk_y));
  travel_m_ = std::max(travel_m_, world.object_travel_m);
  rise_m_ = std::max(rise_m_, world.object.position_m[2] - start_->object_z);
  if (scenario_.height_m > 0) measure_.lift = std::clamp(rise_m_ / scenario_.height_m, 0.0, 1.0);
  const bool moved = scenario_.goal == Goal::kNone || trunk_way_m_ > moved_[0] + kNoticedMoveM ||
                     travel_m_ > moved_[1] + kNoticedMoveM || rise_m_ > moved_[2] + kNoticedRiseM;
  if (!moved) return;
  moved_ = {trunk_way_m_, travel_m_, rise_m_};
  moved_time_s_ = measure_.time_s;
}

}  // namespace scarab::search
