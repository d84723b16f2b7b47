#pragma once

#include <cstdint>

#include "services/robot_bridge/drivers/dynamixel/servo_group.hpp"

namespace scarab::bridge::dynamixel {

/// Goals, then the servos' own time-out, then torque; each read back. Throws DeviceError naming the
/// servo that did not take it; then those that were switched on are switched off again, as far as
/// they answer. `watchdog` counts in the unit of ServoModel::bus_watchdog.
void switch_on(ServoGroup& servos, const Counts& goals, std::int64_t watchdog);

/// Torque off, time-out off, read back. Throws DeviceError naming a servo that keeps its torque.
void switch_off(ServoGroup& servos);

/// The frame of the first instruction of switch_off().
[[nodiscard]] Bytes switch_off_frame(const ServoGroup& servos);

}  // namespace scarab::bridge::dynamixel
