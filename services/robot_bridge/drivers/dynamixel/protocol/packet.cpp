#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"

#include <stdexcept>
#include <string>

#include "services/robot_bridge/drivers/dynamixel/protocol/crc16.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/stuffing.hpp"

namespace scarab::bridge::dynamixel {

Bytes encode(const Packet& packet) {
  Bytes body;
  body.reserve(1 + packet.parameters.size());
  body.push_back(packet.instruction);
  body.insert(body.end(), packet.parameters.begin(), packet.parameters.end());
  if (!is_never_stuffed(packet.id, packet.instruction)) body = stuff(body);

  const std::size_t length = body.size() + kCrcBytes;
  if (length > kMaxLength) {
    throw std::invalid_argument("a packet of length " + std::to_string(length) + ", longest is " +
                                std::to_string(kMaxLength));
  }
  Bytes frame{0xFF, 0xFF, 0xFD, 0x00, packet.id};
  frame.reserve(kPrefixBytes + length);
  append_little(frame, static_cast<std::uint32_t>(length), 2);
  frame.insert(frame.end(), body.begin(), body.end());
  append_little(frame, crc16(frame), kCrcBytes);
  return frame;
}

}  // namespace scarab::bridge::dynamixel
