#include "services/plant/config.hpp"

#include <cmath>

#include "common/config/config.hpp"

namespace scarab::plant {
namespace {

constexpr double kNsPerS = 1e9;
constexpr config::Range kPeriod{1e-6, 10};
constexpr config::Range kFriction{0, 10};

/// `period` is a whole number of `part`s, to the nanosecond.
bool divides(double part_s, double period_s) {
  const auto part = std::llround(part_s * kNsPerS);
  return part > 0 && std::llround(period_s * kNsPerS) % part == 0;
}

}  // namespace

template <class Fields>
void visit_fields(Fields& f, TimingConfig& c) {
  f("step_s", c.step_s, config::Range{1e-6, 0.02});
  f("sensor_period_s", c.sensor_period_s, kPeriod);
  f("control_period_s", c.control_period_s, kPeriod);
}

void validate(const TimingConfig& c, const config::Check& check) {
  check.require(divides(c.step_s, c.sensor_period_s), "sensor_period_s",
                "must be a whole number of steps (step_s)");
  check.require(divides(c.sensor_period_s, c.control_period_s), "control_period_s",
                "must be a whole number of sensor periods (sensor_period_s)");
}

template <class Fields>
void visit_fields(Fields& f, NormalContact& c) {
  f("stiffness_n_m", c.stiffness_n_m, config::kPositive);
  f("damping_n_s_m", c.damping_n_s_m, config::kNonNegative);
}

template <class Fields>
void visit_fields(Fields& f, ContactConfig& c) {
  f("robot", c.robot);
  f("object", c.object);
  f("slip_speed_m_s", c.slip_speed_m_s, config::kPositive);
  f("anchor_stiffness_n_m", c.anchor_stiffness_n_m, config::kNonNegative);
  f("object_rolling_resistance_m", c.object_rolling_resistance_m, config::kNonNegative);
  f("trunk_edge_radius_m", c.trunk_edge_radius_m, config::kNonNegative);
}

template <class Fields>
void visit_fields(Fields& f, FrictionConfig& c) {
  f("foot_ground", c.foot_ground, kFriction);
  f("trunk_ground", c.trunk_ground, kFriction);
  f("foot_object", c.foot_object, kFriction);
  f("trunk_object", c.trunk_object, kFriction);
  f("leg_obstacle", c.leg_obstacle, kFriction);
  f("leg_leg", c.leg_leg, kFriction);
  f("object_ground", c.object_ground, kFriction);
  f("object_obstacle", c.object_obstacle, kFriction);
}

template <class Fields>
void visit_fields(Fields& f, JointStopConfig& c) {
  f("stiffness_nm_rad", c.stiffness_nm_rad, config::kPositive);
  f("damping_nm_s_rad", c.damping_nm_s_rad, config::kNonNegative);
}

template <class Fields>
void visit_fields(Fields& f, ObjectConfig& c) {
  f("length_m", c.length_m, config::kPositive);
  f("diameter_m", c.diameter_m, config::kPositive);
  f("mass_kg", c.mass_kg, config::kPositive);
  f("start_distance_m", c.start_distance_m, config::kPositive);
}

template <class Fields>
void visit_fields(Fields& f, ObstacleConfig& c) {
  f("thickness_m", c.thickness_m, config::kPositive);
  f("gap_m", c.gap_m, config::kPositive);
}

template <class Fields>
void visit_fields(Fields& f, StartConfig& c) {
  f("front_rad", c.front_rad);
  f("middle_rad", c.middle_rad);
  f("hind_rad", c.hind_rad);
  f("backbone_rad", c.backbone_rad);
  f("settle_s", c.settle_s, config::Range{0, 60});
}

template <class Fields>
void visit_fields(Fields& f, SensorNoiseConfig& c) {
  f("position_rad", c.position_rad, config::kNonNegative);
  f("velocity_rad_s", c.velocity_rad_s, config::kNonNegative);
  f("torque_nm", c.torque_nm, config::kNonNegative);
  f("foot_force_n", c.foot_force_n, config::kNonNegative);
  f("inclination_rad", c.inclination_rad, config::kNonNegative);
  f("angular_velocity_rad_s", c.angular_velocity_rad_s, config::kNonNegative);
  f("acceleration_m_s2", c.acceleration_m_s2, config::kNonNegative);
}

template <class Fields>
void visit_fields(Fields& f, RefereeConfig& c) {
  f("across_margin_m", c.across_margin_m, config::kNonNegative);
  f("lost_distance_m", c.lost_distance_m, config::kPositive);
  f("lost_sideways_m", c.lost_sideways_m, config::kPositive);
  f("overturned_tilt_rad", c.overturned_tilt_rad, config::kPositive);
}

template <class Fields>
void visit_fields(Fields& f, PlantConfig& c) {
  f("gravity_m_s2", c.gravity_m_s2, config::kNonNegative);
  f("timing", c.timing);
  f("contact", c.contact);
  f("friction", c.friction);
  f("joint_stop", c.joint_stop);
  f("object", c.object);
  f("obstacle", c.obstacle);
  f("start", c.start);
  f("noise", c.noise);
  f("referee", c.referee);
}

PlantConfig load_config(const std::filesystem::path& path) {
  return config::load<PlantConfig>(path);
}

std::string dump_config(const PlantConfig& config) { return config::dump(config); }

std::string config_schema() { return config::schema<PlantConfig>("Scarab: config/plant"); }

}  // namespace scarab::plant
