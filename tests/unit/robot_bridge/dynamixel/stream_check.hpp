#pragma once

#include <cstddef>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"

namespace scarab::bridge::dynamixel {

/// A packet and where it stands in a stream.
struct Found {
  std::size_t begin = 0;
  std::size_t end = 0;
  Packet packet;
};

/// Every packet that stands anywhere in a stream, overlapping or not, found the slow way and
/// without any of the code under test: each place is tried, the CRC goes bit by bit.
std::vector<Found> packets_in(const Bytes& stream);

}  // namespace scarab::bridge::dynamixel
