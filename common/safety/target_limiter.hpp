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
  /// one of a present joint is not finite; then they are as before.
  void start_from(const robot::JointVector& held_rad);

  /// One tick's move towards `wanted_rad` (finite). Absent joints stay at 0. With `measured_rad`
  /// the torque limit applies too. Adds what it changed to `counters`.
  void advance(const robot::JointVector& wanted_rad,
               const std::optional<robot::JointVector>& measured_rad, GateCounters& counters);

  /// One tick's slow move towards `home_rad` (reachable).
  void advance_home(const robot::JointVector& home_rad);
  /// `home_rad` as far as the joints' ranges let them; 0 for absent joints. Throws
  /// std::invalid_argument if one of a present joint is not finite.
  [[nodiscard]] robot::JointVector reachable(const robot::JointVector& home_rad) const;

  [[nodiscard]] const robot::JointVector& target_rad() const { return target_rad_; }

 private:
  void require_finite(const robot::JointVector& angles_rad, const char* what) const;
  [[nodiscard]] double limited(std::size_t slot, double wanted_rad,
                               const std::optional<robot::JointVector>& measured_rad,
                               GateCounters& counters);

  robot::RobotModel robot_;
  double tick_period_s_;
  double homing_velocity_rad_s_;
  robot::JointVector target_rad_{};
};

}  // namespace scarab::safety
