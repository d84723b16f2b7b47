#pragma once

#include <cstddef>
#include <cstdint>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"

/// Packets of DYNAMIXEL Protocol 2.0 (ROBOTIS e-Manual, "Protocol 2.0"):
///
///     FF FF FD 00 | ID | LEN_L LEN_H | INST | parameters | CRC_L CRC_H
///
/// LEN counts from INST to the CRC, stuffing included; the CRC is over all before it.
namespace scarab::bridge::dynamixel {

enum class Instruction : std::uint8_t {
  kPing = 0x01,
  kRead = 0x02,
  kWrite = 0x03,
  kRegWrite = 0x04,
  kAction = 0x05,
  kReboot = 0x08,
  kStatus = 0x55,  ///< what a device answers; its first parameter is the error byte
  kSyncRead = 0x82,
  kSyncWrite = 0x83,
  kFastSyncRead = 0x8A,
};

inline constexpr std::uint8_t kMaxId = 252;
inline constexpr std::uint8_t kBroadcastId = 254;

/// Header, ID and LEN.
inline constexpr std::size_t kPrefixBytes = 7;
inline constexpr std::size_t kCrcBytes = 2;
/// The largest LEN that is sent or believed: enough for a fast sync read of 50 bytes from each of
/// 19 devices, and it bounds how far a forged header can reach.
inline constexpr std::size_t kMaxLength = 1024;
inline constexpr std::size_t kMaxFrameBytes = kPrefixBytes + kMaxLength;

/// A packet without its wrapping. `instruction` need not be one of Instruction: a device answers an
/// unknown one with an error.
struct Packet {
  std::uint8_t id = 0;
  std::uint8_t instruction = 0;
  Bytes parameters;  ///< not stuffed

  [[nodiscard]] bool is(Instruction of) const {
    return instruction == static_cast<std::uint8_t>(of);
  }
  /// A status; else an instruction (on a two-wire bus a controller may hear its own).
  [[nodiscard]] bool is_status() const { return is(Instruction::kStatus); }
};

inline bool operator==(const Packet& a, const Packet& b) {
  return a.id == b.id && a.instruction == b.instruction && a.parameters == b.parameters;
}

/// Whether such a packet goes over the wire without stuffing: the joint status that answers a fast
/// read, and nothing else (e-Manual, "Fast Sync Read", note on Byte Stuffing).
[[nodiscard]] constexpr bool is_never_stuffed(std::uint8_t id, std::uint8_t instruction) {
  return id == kBroadcastId && instruction == static_cast<std::uint8_t>(Instruction::kStatus);
}

/// The bytes of a packet. Throws std::invalid_argument if its LEN would be above kMaxLength.
[[nodiscard]] Bytes encode(const Packet& packet);

}  // namespace scarab::bridge::dynamixel
