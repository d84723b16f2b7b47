#pragma once

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"

namespace scarab::robot {

/// `angle_rad` moved into the joint's range. Not finite stays not finite: the command gate refuses
/// that.
[[nodiscard]] double clipped_to_range(const Joint& joint, double angle_rad);

/// All angles (rad) moved into their joints' ranges; 0 for absent joints.
[[nodiscard]] JointVector clipped_to_ranges(const RobotModel& model, const JointVector& angles_rad);

}  // namespace scarab::robot
