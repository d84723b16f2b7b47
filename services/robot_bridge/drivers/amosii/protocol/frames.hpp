#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "services/robot_bridge/drivers/amosii/protocol/slots.hpp"

/// The board's frames (57600 baud, 8N1). Byte 0 ends each of them:
///
///     set     01  s[1] .. s[32]  00     34 bytes, not answered
///     get     02  00                     2 bytes
///     reply       p[1] .. p[32]  00     33 bytes, the answer to a get
///
/// There is no checksum. What can be checked of a set is its first byte, its terminator, that no
/// byte between them is 0 (each servo's bytes are 1 or more), and that the 13 outputs without a
/// servo carry 128. Of a reply: its terminator, and that no input that never reads 0 reads 0. So a
/// flipped bit in the value of a servo or a sensor cannot be seen; a lost or an additional byte is.
namespace scarab::bridge::amosii {

inline constexpr unsigned kBaud = 57600;
inline constexpr std::uint8_t kTerminator = 0;
inline constexpr std::uint8_t kSetCommand = 1;
inline constexpr std::uint8_t kGetCommand = 2;

using SetFrame = std::array<std::uint8_t, 1 + kSlotCount + 1>;
using GetFrame = std::array<std::uint8_t, 2>;
using ReplyFrame = std::array<std::uint8_t, kSlotCount + 1>;

inline constexpr GetFrame kGetFrame = {kGetCommand, kTerminator};

/// A value of 0 goes out as 1: it would end the frame.
[[nodiscard]] SetFrame encode_set(const Slots& motors);
[[nodiscard]] ReplyFrame encode_reply(const Slots& sensors);

/// Time that `size` bytes take on the wire: a start bit, eight data bits and a stop bit each.
constexpr double wire_time_s(std::size_t size) {
  return static_cast<double>(10 * size) / static_cast<double>(kBaud);
}

/// What can be checked of a set's values: no 0, and 128 where there is no servo.
[[nodiscard]] bool is_plausible_set(const Slots& motors);
/// What can be checked of a reply's values: no 0 where the input never reads 0.
[[nodiscard]] bool is_plausible_reply(const Slots& sensors);

}  // namespace scarab::bridge::amosii
