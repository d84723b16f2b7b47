#include "services/robot_bridge/drivers/loopback/servos.hpp"

#include <algorithm>

namespace scarab::bridge::loopback {

Servos::Servos(const robot::RobotModel& robot, const robot::JointVector& angle_rad)
    : angle_rad_(angle_rad), goal_rad_(angle_rad) {
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    speed_limit_rad_s_[joint] = robot.joints[joint].velocity_max_rad_s;
  }
}

void Servos::advance(double time_s) {
  if (time_s <= 0) return;
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    const double reach_rad = torque_ && !stuck_[joint] ? speed_limit_rad_s_[joint] * time_s : 0;
    const double step_rad = std::clamp(goal_rad_[joint] - angle_rad_[joint], -reach_rad, reach_rad);
    angle_rad_[joint] += step_rad;
    velocity_rad_s_[joint] = step_rad / time_s;
  }
}

}  // namespace scarab::bridge::loopback
