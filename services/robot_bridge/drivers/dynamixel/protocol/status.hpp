#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"

namespace scarab::bridge::dynamixel {

/// Why a device did not do what it was told: bits 0 to 6 of a status packet's error byte
/// (e-Manual, Protocol 2.0, "Error").
enum class StatusError : std::uint8_t {
  kNone = 0,
  kResultFail = 1,
  kInstruction = 2,
  kCrc = 3,
  kDataRange = 4,
  kDataLength = 5,
  kDataLimit = 6,
  kAccess = 7,
};

/// Bit 7 of the error byte: the device has a problem that its hardware error status tells.
inline constexpr std::uint8_t kAlertBit = 0x80;

/// What a device answers.
struct Status {
  std::uint8_t id = 0;
  bool alert = false;
  StatusError error = StatusError::kNone;  ///< need not be one of those with a name
  Bytes data;
};

inline bool operator==(const Status& a, const Status& b) {
  return a.id == b.id && a.alert == b.alert && a.error == b.error && a.data == b.data;
}

/// In the manual's words, "data limit error"; "error 42" for one that it does not name.
[[nodiscard]] std::string name_of(StatusError error);

[[nodiscard]] std::uint8_t error_byte(const Status& status);
/// A status with all but its data.
[[nodiscard]] Status status_of(std::uint8_t id, std::uint8_t error_byte);

/// How long a status with so much data is on the wire, but for stuffing.
[[nodiscard]] constexpr std::size_t status_bytes(std::size_t data_bytes) {
  return kPrefixBytes + 2 + data_bytes + kCrcBytes;  // instruction and error byte
}

[[nodiscard]] Packet to_packet(const Status& status);
/// None if the packet is no status of one device.
[[nodiscard]] std::optional<Status> as_status(const Packet& packet);

}  // namespace scarab::bridge::dynamixel
