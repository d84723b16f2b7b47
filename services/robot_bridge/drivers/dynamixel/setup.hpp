#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/servo_group.hpp"

/// What is done with the devices once, after the port has been opened. Everything throws
/// DeviceError; no device is ever rebooted by itself, as that drops what its joint carries.
namespace scarab::bridge::dynamixel {

/// What a servo has been told of its own limits.
struct ServoLimits {
  std::int64_t min_ticks = 0;
  std::int64_t max_ticks = 0;
  double temperature_c = 0;
};

/// Pings every servo, and whoever else is to be there. The error names all that are silent, and
/// those where another model answers.
void find_devices(ServoGroup& servos, const std::vector<std::uint8_t>& boards);

/// Motors off; then position control, answers to everything without delay. Persistent settings are
/// only written where they differ.
void prepare(ServoGroup& servos);

/// The limits of each servo. Throws, too, if a calibrated range has no part within them.
[[nodiscard]] std::vector<ServoLimits> read_limits(ServoGroup& servos);

}  // namespace scarab::bridge::dynamixel
