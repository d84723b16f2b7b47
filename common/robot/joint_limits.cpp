#include "common/robot/joint_limits.hpp"

#include <algorithm>

namespace scarab::robot {

double clipped_to_range(const Joint& joint, double angle_rad) {
  return std::clamp(angle_rad, joint.min_rad, joint.max_rad);
}

JointVector clipped_to_ranges(const RobotModel& model, const JointVector& angles_rad) {
  JointVector clipped{};
  for (std::size_t slot = 0; slot < kJointCount; ++slot) {
    const Joint& joint = model.joints[slot];
    if (joint.present) clipped[slot] = clipped_to_range(joint, angles_rad[slot]);
  }
  return clipped;
}

}  // namespace scarab::robot
