#include "tests/unit/robot_bridge/dynamixel/random_stream.hpp"

#include <array>

#include "common/random/random.hpp"

namespace scarab::bridge::dynamixel {

std::size_t RandomStream::below(std::size_t end) {
  return random::bits(seed_, random::stream("dynamixel"), index_++) % end;
}

std::uint8_t RandomStream::byte() {
  constexpr std::array<std::uint8_t, 12> kTelling = {0xFF, 0xFF, 0xFF, 0xFD, 0xFD, 0x00,
                                                     0x00, 0xFE, 0x55, 0x03, 0x07, 0x20};
  return below(3) == 0 ? static_cast<std::uint8_t>(below(256)) : kTelling[below(kTelling.size())];
}

Bytes RandomStream::bytes(std::size_t size) {
  Bytes all;
  while (all.size() < size) all.push_back(byte());
  return all;
}

Packet RandomStream::packet() {
  constexpr std::array<std::uint8_t, 9> kInstructions = {0x01, 0x02, 0x03, 0x55, 0x55,
                                                         0x82, 0x83, 0x8A, 0xEE};
  const auto id = static_cast<std::uint8_t>(below(4) == 0 ? kBroadcastId : below(kMaxId + 1U));
  return {id, kInstructions[below(kInstructions.size())], bytes(1 + below(40))};
}

Bytes RandomStream::garbage() {
  Bytes all;
  for (std::size_t pieces = below(5); pieces > 0; --pieces) {
    Bytes piece;
    switch (below(4)) {
      case 0:
        piece = bytes(below(60));
        break;
      case 1:
        piece = {0xFF, 0xFF, 0xFD, 0x00};
        for (const std::uint8_t next : bytes(below(12))) piece.push_back(next);
        break;
      case 2:
        piece = encode(packet());
        break;
      default:
        piece = broken(encode(packet()));
    }
    all.insert(all.end(), piece.begin(), piece.end());
  }
  return all;
}

Bytes RandomStream::broken(Bytes frame) {
  const auto at = frame.begin() + static_cast<long>(below(frame.size()));
  switch (below(5)) {
    case 0:
      *at = static_cast<std::uint8_t>(*at ^ (1U << below(8)));
      break;
    case 1:
      frame.erase(at);
      break;
    case 2:
      frame.insert(at, byte());
      break;
    case 3:
      frame.erase(at, frame.end());
      break;
    default:
      frame.erase(frame.begin(), at);
  }
  return frame;
}

}  // namespace scarab::bridge::dynamixel
