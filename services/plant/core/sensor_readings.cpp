#include "services/plant/core/sensor_readings.hpp"

#include <algorithm>
#include <string>

#include "services/plant/core/timing.hpp"

namespace scarab::plant {

SensorReadings::Sensor::Sensor(const SensorErrors& errors, std::string_view name,
                               std::uint64_t seed, std::int64_t step_ns)
    : model(errors, name, seed),
      latency_steps(static_cast<std::size_t>(
          whole_steps(errors.latency_s, step_ns, std::string(name) + " latency_s"))) {}

SensorReadings::SensorReadings(const SensorsConfig& config, const JointPresence& present,
                               std::uint64_t seed, std::int64_t step_ns)
    : present_(present),
      joint_position_(config.joint_position, "joint_position", seed, step_ns),
      joint_velocity_(config.joint_velocity, "joint_velocity", seed, step_ns),
      joint_torque_(config.joint_torque, "joint_torque", seed, step_ns),
      foot_force_(config.foot_force, "foot_force", seed, step_ns),
      inclination_(config.inclination, "inclination", seed, step_ns),
      angular_velocity_(config.angular_velocity, "angular_velocity", seed, step_ns),
      acceleration_(config.acceleration, "acceleration", seed, step_ns),
      supply_current_(config.supply_current, "supply_current", seed, step_ns),
      latency_most_(std::max({joint_position_.latency_steps, joint_velocity_.latency_steps,
                              joint_torque_.latency_steps, foot_force_.latency_steps,
                              inclination_.latency_steps, angular_velocity_.latency_steps,
                              acceleration_.latency_steps, supply_current_.latency_steps})),
      history_(latency_most_) {}

template <std::size_t N>
void SensorReadings::sample_each(const Sensor& sensor, std::array<double, N> Observation::*values,
                                 std::uint64_t n) {
  const auto& truth = history_.at(sensor.latency_steps).*values;
  for (std::size_t i = 0; i < N; ++i) {
    if (!sensor.model.lost(i, n)) (newest_.*values)[i] = sensor.model.reading(truth[i], i, n);
  }
}

template <std::size_t N>
void SensorReadings::sample_together(const Sensor& sensor,
                                     std::array<double, N> Observation::*values, std::uint64_t n) {
  if (sensor.model.lost(0, n)) return;
  const auto& truth = history_.at(sensor.latency_steps).*values;
  for (std::size_t i = 0; i < N; ++i) {
    (newest_.*values)[i] = sensor.model.reading(truth[i], i, n);
  }
}

robot::JointVector SensorReadings::encoder_offset_rad() const {
  robot::JointVector out{};
  for (std::size_t j = 0; j < out.size(); ++j) {
    if (present_[j]) out[j] = joint_position_.model.bias(j);
  }
  return out;
}

void SensorReadings::sample(std::uint64_t n) {
  sample_each(joint_position_, &Observation::position_rad, n);
  sample_each(joint_velocity_, &Observation::velocity_rad_s, n);
  sample_each(joint_torque_, &Observation::torque_nm, n);
  sample_each(foot_force_, &Observation::foot_force_n, n);
  sample_together(angular_velocity_, &Observation::angular_velocity_rad_s, n);
  sample_together(acceleration_, &Observation::acceleration_m_s2, n);
  if (!inclination_.model.lost(0, n)) {
    const Observation& truth = history_.at(inclination_.latency_steps);
    newest_.roll_rad = inclination_.model.reading(truth.roll_rad, 0, n);
    newest_.pitch_rad = inclination_.model.reading(truth.pitch_rad, 1, n);
  }
  if (!supply_current_.model.lost(0, n)) {
    const Observation& truth = history_.at(supply_current_.latency_steps);
    newest_.supply_current_a = supply_current_.model.reading(truth.supply_current_a, 0, n);
  }
  for (double& force : newest_.foot_force_n) force = std::max(0.0, force);  // a pad cannot pull
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (present_[j]) continue;
    newest_.position_rad[j] = newest_.velocity_rad_s[j] = newest_.torque_nm[j] = 0;
  }
}

}  // namespace scarab::plant
