#pragma once

#include <array>
#include <optional>

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"
#include "common/safety/gate_counters.hpp"

namespace scarab::safety {

/// Moves the targets of all joints towards what is wanted, as far as range, torque and speed allow.
/// Each joint can be in homing, where it is slow until it has caught up with what is wanted.
class TargetLimiter {
 public:
  /// `homing_velocity_rad_s`: speed limit of a homing joint, where the joint's own is not lower.
  TargetLimiter(robot::RobotModel robot, double tick_period_s, double homing_velocity_rad_s);

  /// Sets the targets as they are given: where the robot stands. A joint that is homing goes on
  /// homing. Throws std::invalid_argument if one of a present joint is not finite.
  void start_from(const robot::JointVector& held_rad);

  /// One tick's move towards `wanted_rad` (finite). Absent joints stay at 0. With `measured_rad`
  /// the torque limit applies too. Adds what it changed to `counters`.
  void advance(const robot::JointVector& wanted_rad,
               const std::optional<robot::JointVector>& measured_rad, GateCounters& counters);

  void begin_homing() { homing_.fill(true); }
  [[nodiscard]] bool homing() const;
  [[nodiscard]] const robot::JointVector& target_rad() const { return target_rad_; }

 private:
  [[nodiscard]] double limited(std::size_t slot, double wanted_rad,
                               const std::optional<robot::JointVector>& measured_rad,
                               GateCounters& counters);

  robot::RobotModel robot_;
  double tick_period_s_;
  double homing_velocity_rad_s_;
  robot::JointVector target_rad_{};
  std::array<bool, robot::kJointCount> homing_{};
};

}  // namespace scarab::safety
