#pragma once

#include <vector>

#include "services/robot_bridge/core/readings.hpp"
#include "services/robot_bridge/drivers/dynamixel/servo_group.hpp"

namespace scarab::bridge::dynamixel {

/// Where the servos have what they measure all the time: current, velocity, position. One block, so
/// that one instruction reads it.
[[nodiscard]] Region feedback_region(const ServoGroup& servos);

/// Position, velocity, torque and current of each joint, and the robot's supply current, from the
/// answers to a read of feedback_region(). Torque is that of the current. The supply current is the
/// sum of the servos' magnitudes: what the boards take is not in it.
void decode_feedback(const ServoGroup& servos, const std::vector<Status>& answers,
                     Readings& readings);

/// The positions in the same answers.
[[nodiscard]] Counts positions_in(const ServoGroup& servos, const std::vector<Status>& answers);

}  // namespace scarab::bridge::dynamixel
