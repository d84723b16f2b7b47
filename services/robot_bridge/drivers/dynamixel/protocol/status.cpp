#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"

namespace scarab::bridge::dynamixel {

std::string name_of(StatusError error) {
  switch (error) {
    case StatusError::kNone:
      return "no error";
    case StatusError::kResultFail:
      return "result fail";
    case StatusError::kInstruction:
      return "instruction error";
    case StatusError::kCrc:
      return "CRC error";
    case StatusError::kDataRange:
      return "data range error";
    case StatusError::kDataLength:
      return "data length error";
    case StatusError::kDataLimit:
      return "data limit error";
    case StatusError::kAccess:
      return "access error";
  }
  return "error " + std::to_string(static_cast<int>(error));
}

std::uint8_t error_byte(const Status& status) {
  const auto number = static_cast<std::uint8_t>(status.error);
  return status.alert ? static_cast<std::uint8_t>(number | kAlertBit) : number;
}

Status status_of(std::uint8_t id, std::uint8_t error_byte) {
  Status status;
  status.id = id;
  status.alert = (error_byte & kAlertBit) != 0;
  status.error = static_cast<StatusError>(error_byte & ~kAlertBit);
  return status;
}

Packet to_packet(const Status& status) {
  Packet packet{status.id, static_cast<std::uint8_t>(Instruction::kStatus), {}};
  packet.parameters.reserve(1 + status.data.size());
  packet.parameters.push_back(error_byte(status));
  packet.parameters.insert(packet.parameters.end(), status.data.begin(), status.data.end());
  return packet;
}

std::optional<Status> as_status(const Packet& packet) {
  if (!packet.is_status() || packet.id > kMaxId || packet.parameters.empty()) return std::nullopt;
  Status status = status_of(packet.id, packet.parameters.front());
  status.data.assign(packet.parameters.begin() + 1, packet.parameters.end());
  return status;
}

}  // namespace scarab::bridge::dynamixel
