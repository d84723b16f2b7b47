#pragma once

#include <string_view>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"

namespace scarab::bridge::dynamixel {

/// Bytes from text as manuals print them: "FF FF FD 00".
Bytes hex(std::string_view text);

/// The packets in a stream that a new parser gets at once.
std::vector<Packet> parse(ByteView stream);

/// The one packet that a whole frame is; fails the test and gives an empty packet if it is not.
Packet parse_one(ByteView frame);

}  // namespace scarab::bridge::dynamixel
