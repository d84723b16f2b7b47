#include "services/robot_bridge/core/calibration.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace scarab::bridge {

double to_servo_rad(const JointCalibration& c, double joint_rad) noexcept {
  return std::clamp(c.offset_rad + c.direction * joint_rad, c.min_rad, c.max_rad);
}

double to_joint_rad(const JointCalibration& c, double servo_rad) noexcept {
  return c.direction * (servo_rad - c.offset_rad);
}

double turned(const JointCalibration& c, double value) noexcept { return c.direction * value; }

JointRange reach(const JointCalibration& c) noexcept {
  const double a = to_joint_rad(c, c.min_rad);
  const double b = to_joint_rad(c, c.max_rad);
  return {std::min(a, b), std::max(a, b)};
}

Calibration of_robot(const Calibration& c, const robot::RobotModel& robot) {
  Calibration own;
  for (std::size_t slot = 0; slot < robot.joints.size(); ++slot) {
    if (!robot.joints[slot].present) continue;
    if (!c.joints[slot]) {
      throw std::invalid_argument("joint " + std::string(robot::kJointNames[slot]) + " of " +
                                  robot.name + " has no calibration");
    }
    own.joints[slot] = c.joints[slot];
  }
  return own;
}

robot::RobotModel within_reach(robot::RobotModel robot, const Calibration& c) {
  for (std::size_t slot = 0; slot < robot.joints.size(); ++slot) {
    robot::Joint& joint = robot.joints[slot];
    if (!joint.present || !c.joints[slot]) continue;
    const JointRange range = reach(*c.joints[slot]);
    joint.min_rad = std::max(joint.min_rad, range.min_rad);
    joint.max_rad = std::min(joint.max_rad, range.max_rad);
  }
  return robot;
}

}  // namespace scarab::bridge
