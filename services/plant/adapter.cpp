#include "services/plant/adapter.hpp"

#include <algorithm>
#include <iterator>

#include "common/bus/sample_fields.hpp"

namespace scarab::plant {
namespace {

template <class Core, class Idl>
constexpr bool same(Core core, Idl idl) {
  return static_cast<int>(core) == static_cast<int>(idl);
}

static_assert(same(Goal::kNone, scarab_GOAL_NONE) && same(Goal::kTravel, scarab_GOAL_TRAVEL) &&
              same(Goal::kAcross, scarab_GOAL_ACROSS) && same(Goal::kWalk, scarab_GOAL_WALK));
static_assert(same(Solid::kGround, scarab_SOLID_GROUND) &&
              same(Solid::kTrunk, scarab_SOLID_TRUNK) && same(Solid::kFoot, scarab_SOLID_FOOT));
static_assert(same(Verdict::kOpen, scarab_VERDICT_OPEN) &&
              same(Verdict::kFailure, scarab_VERDICT_FAILURE));

template <class From, std::size_t N>
void copy(const From& from, double (&to)[N]) {
  std::copy(from.begin(), from.end(), std::begin(to));
}

void fill(scarab_Pose& pose, const Pose& core) {
  copy(core.position_m, pose.position_m);
  copy(core.orientation_wxyz, pose.orientation_wxyz);
}

void fill(scarab_Twist& twist, const Twist& core) {
  copy(core.linear_m_s, twist.linear_m_s);
  copy(core.angular_rad_s, twist.angular_rad_s);
}

scarab_Contact to_contact(const ContactTruth& core) {
  scarab_Contact contact{};
  contact.solid_a = static_cast<scarab_Solid>(core.solid_a);
  contact.leg_a = core.leg_a;
  contact.solid_b = static_cast<scarab_Solid>(core.solid_b);
  contact.leg_b = core.leg_b;
  copy(core.point_m, contact.point_m);
  copy(core.force_n, contact.force_n);
  contact.depth_m = core.depth_m;
  return contact;
}

}  // namespace

TrialSpec to_trial_spec(const scarab_Trial& trial) {
  TrialSpec spec;
  spec.goal = static_cast<Goal>(trial.goal);
  spec.goal_distance_m = trial.goal_distance_m;
  spec.time_limit_s = trial.time_limit_s;
  spec.obstacle_height_m = trial.obstacle_height_m;
  spec.seed = trial.seed;
  spec.perturb_position_m = trial.perturb_position_m;
  spec.perturb_yaw_rad = trial.perturb_yaw_rad;
  spec.perturb_friction = trial.perturb_friction;
  spec.friction_scale = trial.friction_scale;
  spec.object_mass_kg = trial.object_mass_kg;
  spec.object_diameter_m = trial.object_diameter_m;
  return spec;
}

void fill(scarab_RobotState& state, const Observation& observation,
          const robot::RobotModel& robot) {
  copy(observation.position_rad, state.position_rad);
  copy(observation.velocity_rad_s, state.velocity_rad_s);
  copy(observation.torque_nm, state.torque_nm);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto source = robot.joints[joint].present ? scarab_SOURCE_MEASURED : scarab_SOURCE_ABSENT;
    state.position_source[joint] = source;
    state.velocity_source[joint] = source;
    state.torque_source[joint] = source;
  }
  copy(observation.foot_force_n, state.foot_force_n);
  std::fill(std::begin(state.foot_force_source), std::end(state.foot_force_source),
            scarab_SOURCE_MEASURED);
  state.inclination_rad[0] = observation.roll_rad;
  state.inclination_rad[1] = observation.pitch_rad;
  copy(observation.angular_velocity_rad_s, state.angular_velocity_rad_s);
  copy(observation.acceleration_m_s2, state.acceleration_m_s2);
  state.imu_source = scarab_SOURCE_MEASURED;
  state.motion_source = scarab_SOURCE_MEASURED;
  state.supply_current_a = observation.supply_current_a;
  state.supply_current_source = scarab_SOURCE_MEASURED;
}

void fill(scarab_WorldState& state, const WorldTruth& truth,
          std::vector<scarab_Contact>& contacts) {
  fill(state.trunk, truth.trunk);
  fill(state.trunk_twist, truth.trunk_twist);
  fill(state.object, truth.object);
  fill(state.object_twist, truth.object_twist);
  state.object_travel_m = truth.object_travel_m;
  state.obstacle_present = truth.obstacle_present;
  state.obstacle_x_m = truth.obstacle_x_m;
  state.obstacle_height_m = truth.obstacle_height_m;
  const std::size_t kept = std::min(truth.contacts.size(), kContactsMost);
  contacts.clear();
  for (std::size_t i = 0; i < kept; ++i) contacts.push_back(to_contact(truth.contacts[i]));
  bus::borrow(state.contacts, contacts);
  state.contacts_dropped = static_cast<std::uint32_t>(truth.contacts.size() - kept);
  state.verdict = static_cast<scarab_Verdict>(truth.verdict);
  state.verdict_time_s = truth.verdict_time_s;
  bus::assign_truncated(state.verdict_reason, truth.verdict_reason);
}

}  // namespace scarab::plant
