#pragma once

#include <cstdint>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"

namespace scarab::bridge::dynamixel {

/// CRC-16 with polynomial 0x8005, initial value 0, not reflected, no final inversion (ROBOTIS
/// e-Manual, "CRC Calculation"; also known as CRC-16/BUYPASS): of "123456789" it is 0xFEE8.
/// `before` is the CRC of what went before `bytes`.
[[nodiscard]] std::uint16_t crc16(ByteView bytes, std::uint16_t before = 0) noexcept;

}  // namespace scarab::bridge::dynamixel
