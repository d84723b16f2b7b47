#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "services/robot_bridge/drivers/dynamixel/config.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/control_table.hpp"

namespace scarab::bridge::dynamixel {

/// The servo of one joint, and how it sits there.
struct Servo {
  std::size_t joint = 0;  ///< slot
  std::uint8_t id = 0;
  ServoModel model;
  JointCalibration calibration;
};

/// A servo for each joint that the robot has, by slots. Throws std::invalid_argument naming the
/// joint if one has no servo or no calibration.
[[nodiscard]] std::vector<Servo> servos_of(const Config& config, const robot::RobotModel& robot,
                                           const Calibration& calibration);

/// "joint TL0".
[[nodiscard]] std::string name_of(const Servo& servo);

/// The nearest goal for a joint's angle, ended at the calibrated range.
[[nodiscard]] std::int64_t goal_ticks(const Servo& servo, double joint_rad);

/// The joint's angle for a position of its servo.
[[nodiscard]] double joint_rad(const Servo& servo, std::int64_t ticks);

}  // namespace scarab::bridge::dynamixel
