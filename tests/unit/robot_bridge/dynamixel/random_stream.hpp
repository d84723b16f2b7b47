#pragma once

#include <cstddef>
#include <cstdint>

#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"

namespace scarab::bridge::dynamixel {

/// Random bytes and packets of one seed: the same for the same seed, everywhere.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : seed_(seed) {}

  /// In [0, end).
  std::size_t below(std::size_t end);
  /// A byte, more often than not one that headers, lengths and stuffing are made of.
  std::uint8_t byte();
  Bytes bytes(std::size_t size);
  /// A packet of any kind: instruction, status, fast status, unknown.
  Packet packet();
  /// A few pieces: noise, packets, broken packets.
  Bytes garbage();

 private:
  Bytes broken(Bytes frame);

  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

}  // namespace scarab::bridge::dynamixel
