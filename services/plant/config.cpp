#include "services/plant/config.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/config/config.hpp"
#include "common/runtime/logger_lead.hpp"

namespace scarab::plant {
namespace {

constexpr double kNsPerS = 1e9;
constexpr config::Range kPeriod{1e-6, 10};
constexpr config::Range kFriction{0, 10};
constexpr config::Range kDelay{0, 0.5};  // beyond it no controller of this kind walks
constexpr config::Range kLoss{0, 0.99};  // a sensor that never reads is an absent one

/// `period` is a whole number of `part`s, to the nanosecond.
bool divides(double part_s, double period_s) {
  const auto part = std::llround(part_s * kNsPerS);
  return part > 0 && std::llround(period_s * kNsPerS) % part == 0;
}

/// Names of the keys that carry a sensor's unit.
struct UnitKeys {
  std::string_view noise;
  std::string_view bias;
  std::string_view quantum;
};

constexpr UnitKeys unit_keys(Quantity quantity) {
  switch (quantity) {
    case Quantity::kAngle:
      return {"noise_rad", "bias_rad", "quantum_rad"};
    case Quantity::kAngularVelocity:
      return {"noise_rad_s", "bias_rad_s", "quantum_rad_s"};
    case Quantity::kTorque:
      return {"noise_nm", "bias_nm", "quantum_nm"};
    case Quantity::kForce:
      return {"noise_n", "bias_n", "quantum_n"};
    case Quantity::kAcceleration:
      return {"noise_m_s2", "bias_m_s2", "quantum_m_s2"};
    case Quantity::kCurrent:
      return {"noise_a", "bias_a", "quantum_a"};
  }
  throw std::invalid_argument("no such quantity");
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
  check.require(c.control_period_s < (runtime::kMostSamplesPerTick + 0.5) * c.sensor_period_s,
                "sensor_period_s",
                "gives more than " + std::to_string(runtime::kMostSamplesPerTick) +
                    " samples a tick (control_period_s): no logger could be waited for");
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
void visit_fields(Fields& f, SupplyConfig& c) {
  f("idle_a", c.idle_a, config::kNonNegative);
  f("torque_constant_nm_a", c.torque_constant_nm_a, config::kPositive);
}

template <class Fields, Quantity kQuantity>
void visit_fields(Fields& f, SensorConfig<kQuantity>& c) {
  constexpr UnitKeys keys = unit_keys(kQuantity);
  f(keys.noise, c.noise, config::kNonNegative);
  f(keys.bias, c.bias, config::kNonNegative);
  f(keys.quantum, c.quantum, config::kNonNegative);
  f("latency_s", c.latency_s, kDelay);
  f("dropout", c.dropout, kLoss);
}

template <class Fields>
void visit_fields(Fields& f, SensorsConfig& c) {
  f("joint_position", c.joint_position);
  f("joint_velocity", c.joint_velocity);
  f("joint_torque", c.joint_torque);
  f("foot_force", c.foot_force);
  f("inclination", c.inclination);
  f("angular_velocity", c.angular_velocity);
  f("acceleration", c.acceleration);
  f("supply_current", c.supply_current);
}

template <class Fields>
void visit_fields(Fields& f, CommandPathConfig& c) {
  f("latency_s", c.latency_s, kDelay);
  f("jitter_s", c.jitter_s, kDelay);
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
  f("supply", c.supply);
  f("sensors", c.sensors);
  f("commands", c.commands);
  f("referee", c.referee);
}

void validate(const PlantConfig& c, const config::Check& check) {
  const auto whole = [&](double time_s, std::string_view key) {
    check.require(divides(c.timing.step_s, time_s), key,
                  "must be a whole number of steps (timing.step_s)");
  };
  whole(c.sensors.joint_position.latency_s, "sensors.joint_position.latency_s");
  whole(c.sensors.joint_velocity.latency_s, "sensors.joint_velocity.latency_s");
  whole(c.sensors.joint_torque.latency_s, "sensors.joint_torque.latency_s");
  whole(c.sensors.foot_force.latency_s, "sensors.foot_force.latency_s");
  whole(c.sensors.inclination.latency_s, "sensors.inclination.latency_s");
  whole(c.sensors.angular_velocity.latency_s, "sensors.angular_velocity.latency_s");
  whole(c.sensors.acceleration.latency_s, "sensors.acceleration.latency_s");
  whole(c.sensors.supply_current.latency_s, "sensors.supply_current.latency_s");
  whole(c.commands.latency_s, "commands.latency_s");
  whole(c.commands.jitter_s, "commands.jitter_s");
}

PlantConfig load_config(const std::filesystem::path& path) {
  return config::load<PlantConfig>(path);
}

PlantConfig load_config_text(const std::string& file, const std::string& text) {
  return config::load_text<PlantConfig>(file, text);
}

std::string dump_config(const PlantConfig& config) { return config::dump(config); }

std::string config_schema() { return config::schema<PlantConfig>("Scarab: config/plant"); }

}  // namespace scarab::plant
