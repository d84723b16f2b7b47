#pragma once

#include <array>

#include "common/robot/robot_model.hpp"

namespace scarab::bridge::loopback {

/// Servos without a load: each turns to its goal at its speed limit. Angles on the servos' own
/// scales, rad.
class Servos {
 public:
  Servos(const robot::RobotModel& robot, const robot::JointVector& angle_rad);

  void set_goals(const robot::JointVector& goal_rad) { goal_rad_ = goal_rad; }
  /// A servo without torque stays where it is.
  void set_torque(bool on) { torque_ = on; }
  void set_stuck(std::size_t joint, bool stuck) { stuck_[joint] = stuck; }
  /// Goals become where the servos are.
  void stop() { goal_rad_ = angle_rad_; }
  void advance(double time_s);

  [[nodiscard]] const robot::JointVector& angle_rad() const { return angle_rad_; }
  /// Mean of the last advance().
  [[nodiscard]] const robot::JointVector& velocity_rad_s() const { return velocity_rad_s_; }

 private:
  robot::JointVector speed_limit_rad_s_{};
  robot::JointVector angle_rad_;
  robot::JointVector goal_rad_;
  robot::JointVector velocity_rad_s_{};
  std::array<bool, robot::kJointCount> stuck_{};
  bool torque_ = false;
};

}  // namespace scarab::bridge::loopback
