#include "services/robot_bridge/calibrate/request.hpp"

#include <algorithm>

namespace scarab::bridge::calibrate {

std::vector<std::size_t> asked_joints(const Request& request, const robot::RobotModel& robot) {
  std::vector<std::size_t> joints;
  for (const std::string& name : request.joints) {
    const auto found = std::find(robot::kJointNames.begin(), robot::kJointNames.end(), name);
    const auto slot = static_cast<std::size_t>(found - robot::kJointNames.begin());
    if (slot == robot::kJointCount || !robot.joints[slot].present) {
      throw BadRequest("--joints", "the robot " + robot.name + " has no joint " + name);
    }
  }
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    const auto named =
        std::find(request.joints.begin(), request.joints.end(), robot::kJointNames[joint]);
    const bool asked = request.joints.empty() || named != request.joints.end();
    if (asked && robot.joints[joint].present) joints.push_back(joint);
  }
  return joints;
}

}  // namespace scarab::bridge::calibrate
