#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/robot_bridge/core/readings.hpp"
#include "services/robot_bridge/drivers/dynamixel/bus.hpp"
#include "services/robot_bridge/drivers/dynamixel/config.hpp"

/// Boards on the servos' bus that measure what servos cannot; each is read with one instruction.
namespace scarab::bridge::dynamixel {

/// The IDs of the boards that a configuration has.
[[nodiscard]] std::vector<std::uint8_t> boards_of(const Config& config);

/// The bytes in which a board has all its values.
[[nodiscard]] Region region_of(const ImuConfig& board);
[[nodiscard]] Region region_of(const FootForceConfig& board);

/// Throw what the bus throws.
void read_board(Bus& bus, const ImuConfig& board, Readings& readings);
void read_board(Bus& bus, const FootForceConfig& board, Readings& readings);

}  // namespace scarab::bridge::dynamixel
