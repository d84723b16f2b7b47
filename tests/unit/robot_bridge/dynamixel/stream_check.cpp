#include "tests/unit/robot_bridge/dynamixel/stream_check.hpp"

#include <optional>

namespace scarab::bridge::dynamixel {
namespace {

unsigned slow_crc(const Bytes& bytes, std::size_t begin, std::size_t end) {
  unsigned crc = 0;
  for (std::size_t i = begin; i < end; ++i) {
    for (int bit = 7; bit >= 0; --bit) {
      const bool out = ((crc >> 15) & 1U) != ((unsigned{bytes[i]} >> bit) & 1U);
      crc = (crc << 1) & 0xFFFFU;
      if (out) crc ^= 0x8005U;
    }
  }
  return crc;
}

/// Walks a body with the last three plain bytes in mind.
std::optional<Bytes> slow_unstuff(const Bytes& bytes, std::size_t begin, std::size_t end) {
  Bytes plain;
  unsigned last = 0;
  bool owed = false;
  for (std::size_t i = begin; i < end; ++i) {
    if (owed) {
      if (bytes[i] != 0xFD) return std::nullopt;
      owed = false;
      last = 0;
      continue;
    }
    plain.push_back(bytes[i]);
    last = ((last << 8) | bytes[i]) & 0xFFFFFFU;
    owed = last == 0xFFFFFDU;
  }
  if (owed) return std::nullopt;
  return plain;
}

std::optional<Found> packet_at(const Bytes& s, std::size_t at) {
  if (at + 10 > s.size()) return std::nullopt;
  if (s[at] != 0xFF || s[at + 1] != 0xFF || s[at + 2] != 0xFD || s[at + 3] != 0)
    return std::nullopt;
  const unsigned id = s[at + 4];
  const std::size_t length = s[at + 5] + 256U * s[at + 6];
  if (id == 253 || id == 255 || length < 3 || length > 1024) return std::nullopt;
  const std::size_t end = at + 7 + length;
  if (end > s.size()) return std::nullopt;
  if (slow_crc(s, at, end - 2) != s[end - 2] + 256U * s[end - 1]) return std::nullopt;
  std::optional<Bytes> body =
      Bytes(s.begin() + static_cast<long>(at + 7), s.begin() + static_cast<long>(end - 2));
  const bool fast_status = id == 254 && s[at + 7] == 0x55;
  if (!fast_status) body = slow_unstuff(s, at + 7, end - 2);
  if (!body) return std::nullopt;
  Found found{at, end, {static_cast<std::uint8_t>(id), body->front(), {}}};
  found.packet.parameters.assign(body->begin() + 1, body->end());
  return found;
}

}  // namespace

std::vector<Found> packets_in(const Bytes& stream) {
  std::vector<Found> all;
  for (std::size_t at = 0; at < stream.size(); ++at) {
    if (auto found = packet_at(stream, at)) all.push_back(std::move(*found));
  }
  return all;
}

}  // namespace scarab::bridge::dynamixel
