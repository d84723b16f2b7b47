#include "services/robot_bridge/drivers/dynamixel/protocol/stuffing.hpp"

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::uint8_t kStuffing = 0xFD;

/// Whether an FF FF FD ends at `last`.
bool pattern_ends(ByteView bytes, std::size_t last) {
  return last >= 2 && bytes[last] == 0xFD && bytes[last - 1] == 0xFF && bytes[last - 2] == 0xFF;
}

}  // namespace

Bytes stuff(ByteView body) {
  Bytes stuffed;
  stuffed.reserve(body.size() + 4);
  for (std::size_t i = 0; i < body.size(); ++i) {
    stuffed.push_back(body[i]);
    if (pattern_ends(body, i)) stuffed.push_back(kStuffing);
  }
  return stuffed;
}

std::optional<Bytes> unstuff(ByteView body) {
  if (find_unstuffed(body, body.size())) return std::nullopt;
  Bytes plain;
  plain.reserve(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    plain.push_back(body[i]);
    if (pattern_ends(body, i)) ++i;  // over the FD that means nothing
  }
  return plain;
}

std::optional<std::size_t> find_unstuffed(ByteView begun, std::size_t whole) {
  for (std::size_t i = 2; i < begun.size(); ++i) {
    if (!pattern_ends(begun, i)) continue;
    ++i;  // to the byte that must be an FD
    if (i == whole) return i;
    if (i < begun.size() && begun[i] != kStuffing) return i;
  }
  return std::nullopt;
}

}  // namespace scarab::bridge::dynamixel
