#pragma once

#include <array>
#include <optional>

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"
#include "common/safety/gate_counters.hpp"

namespace scarab::safety {

/// Moves the targets of all joints towards what is wanted, as far as range, torque and speed allow.
class TargetLimiter {
 public:
  /// `homing_velocity_rad_s`: speed limit of every joint on its way home, where its own is not
  /// lower.
  TargetLimiter(robot::RobotModel robot, double tick_period_s, double homing_velocity_rad_s);

  /// Sets the targets as they are given: where the robot stands. Throws std::invalid_argument if
  /// one of a present joint is not finite.
  void start_from(const robot::JointVector& held_rad);

  /// One tick's move towards `wanted_rad` (finite). Absent joints stay at 0. With `measured_rad`
  /// the torque limit applies too. Adds what it changed to `counters`.
  void advance(const robot::JointVector& wanted_rad,
               const std::optional<robot::JointVector>& measured_rad, GateCounters& counters);

  /// One tick's slow move towards `home_rad`, inside the joints' ranges.
  void advance_home(const robot::JointVector& home_rad);
  /// All targets are as near to `home_rad` as the joints' ranges let them.
  [[nodiscard]] bool is_at(const robot::JointVector& home_rad) const;

  [[nodiscard]] const robot::JointVector& target_rad() const { return target_rad_; }

 private:
  [[nodiscard]] double limited(std::size_t slot, double wanted_rad,
                               const std::optional<robot::JointVector>& measured_rad,
                               GateCounters& counters);

  robot::RobotModel robot_;
  double tick_period_s_;
  double homing_velocity_rad_s_;
  robot::JointVector target_rad_{};
};

}  // namespace scarab::safety
