#include "tests/unit/robot_bridge/dynamixel/frames.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace scarab::bridge::dynamixel {

Bytes hex(std::string_view text) {
  std::istringstream in{std::string(text)};
  Bytes bytes;
  for (std::string byte; in >> byte;) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(byte, nullptr, 16)));
  }
  return bytes;
}

std::vector<Packet> parse(ByteView stream) {
  Parser parser;
  std::vector<Packet> packets;
  parser.feed(stream, packets);
  return packets;
}

Packet parse_one(ByteView frame) {
  const std::vector<Packet> packets = parse(frame);
  EXPECT_EQ(packets.size(), 1U);
  return packets.size() == 1 ? packets.front() : Packet{};
}

}  // namespace scarab::bridge::dynamixel
