#pragma once

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"

namespace scarab::bridge::calibrate {

/// A calibration with which a driver speaks of servo angles in place of joint angles, a whole turn
/// of each of the robot's joints.
[[nodiscard]] Calibration own_scales(const robot::RobotModel& robot);

/// The same for servos that take fractions of a travel: as long as `known` says, or else, to begin
/// with, as the joint's range.
[[nodiscard]] Calibration own_scales(const robot::RobotModel& robot, const Calibration& known);

}  // namespace scarab::bridge::calibrate
