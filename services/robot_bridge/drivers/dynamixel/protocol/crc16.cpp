#include "services/robot_bridge/drivers/dynamixel/protocol/crc16.hpp"

#include <array>

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::uint32_t kPolynomial = 0x8005;

/// What each byte at the top of the register leaves of it after eight shifts.
constexpr std::array<std::uint16_t, 256> make_table() {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t crc = byte << 8U;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ kPolynomial : crc << 1U;
    }
    table[byte] = static_cast<std::uint16_t>(crc);
  }
  return table;
}

constexpr std::array<std::uint16_t, 256> kTable = make_table();

}  // namespace

std::uint16_t crc16(ByteView bytes, std::uint16_t before) noexcept {
  std::uint32_t crc = before;
  for (const std::uint8_t byte : bytes) {
    crc = ((crc << 8U) ^ kTable[(crc >> 8U) ^ byte]) & 0xFFFFU;
  }
  return static_cast<std::uint16_t>(crc);
}

}  // namespace scarab::bridge::dynamixel
