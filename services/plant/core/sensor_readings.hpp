#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "common/robot/joints.hpp"
#include "services/plant/core/observation.hpp"
#include "services/plant/core/sensor_config.hpp"
#include "services/plant/core/sensor_errors.hpp"
#include "services/plant/core/truth_history.hpp"

namespace scarab::plant {

/// Which joints the robot has.
using JointPresence = std::array<bool, robot::kJointCount>;

/// What the robot's sensors read: the truth of a latency ago, with each sensor's errors, or the
/// last reading where a sample was lost.
///
/// The truth is kept at every physics step, so that a latency is exact and nothing is interpolated:
/// a blend of two steps would be a force or a speed that never was.
///
/// Each joint and each foot loses samples by itself (every servo answers for itself); the axes of a
/// signal of the IMU are lost together (they are one message).
class SensorReadings {
 public:
  /// Throws std::invalid_argument, naming the sensor, for a latency that is no whole number of
  /// steps.
  SensorReadings(const SensorsConfig& config, const JointPresence& present, std::uint64_t seed,
                 std::int64_t step_ns);

  /// Whether see() is needed after every step; else before a sample is enough.
  [[nodiscard]] bool needs_every_step() const { return latency_most_ > 0; }

  /// What ideal sensors would read after one more physics step.
  void see(const Observation& truth) { history_.push(truth); }

  /// Takes sample `n`, at the time of the truth seen last. Samples are taken in order, from 0.
  void sample(std::uint64_t n);

  /// How far each joint's encoder reads beyond the joint's angle, constant in a trial. A servo that
  /// closes its loop on this encoder turns the joint to its target minus this.
  [[nodiscard]] robot::JointVector encoder_offset_rad() const;

  /// The newest sample. Absent joints read 0.
  [[nodiscard]] const Observation& newest() const { return newest_; }

 private:
  struct Sensor {
    Sensor(const SensorErrors& errors, std::string_view name, std::uint64_t seed,
           std::int64_t step_ns);
    SensorErrorModel model;
    std::size_t latency_steps;
  };

  template <std::size_t N>
  void sample_each(const Sensor& sensor, std::array<double, N> Observation::*values,
                   std::uint64_t n);
  template <std::size_t N>
  void sample_together(const Sensor& sensor, std::array<double, N> Observation::*values,
                       std::uint64_t n);

  JointPresence present_;
  Sensor joint_position_;
  Sensor joint_velocity_;
  Sensor joint_torque_;
  Sensor foot_force_;
  Sensor inclination_;
  Sensor angular_velocity_;
  Sensor acceleration_;
  Sensor supply_current_;
  std::size_t latency_most_;
  TruthHistory history_;
  Observation newest_;
};

}  // namespace scarab::plant
