#include "services/robot_bridge/drivers/amosii/protocol/frames.hpp"

#include <algorithm>

namespace scarab::bridge::amosii {
namespace {

/// The slots as they go over the wire, written from `out` on.
template <class Iterator>
void write_slots(const Slots& slots, Iterator out) {
  std::transform(slots.bytes.begin(), slots.bytes.end(), out,
                 [](std::uint8_t byte) { return std::max<std::uint8_t>(byte, 1); });
}

}  // namespace

SetFrame encode_set(const Slots& motors) {
  SetFrame frame{};
  frame.front() = kSetCommand;
  write_slots(motors, frame.begin() + 1);
  frame.back() = kTerminator;
  return frame;
}

ReplyFrame encode_reply(const Slots& sensors) {
  ReplyFrame frame{};
  write_slots(sensors, frame.begin());
  frame.back() = kTerminator;
  return frame;
}

bool is_plausible_set(const Slots& motors) {
  for (std::size_t slot = 1; slot <= kSlotCount; ++slot) {
    const std::uint8_t byte = motors[slot];
    if (byte == 0 || (!is_motor_slot(slot) && byte != kMiddle)) return false;
  }
  return true;
}

bool is_plausible_reply(const Slots& sensors) {
  for (std::size_t slot = 1; slot <= kSlotCount; ++slot) {
    if (sensors[slot] == 0 && is_never_zero(slot)) return false;
  }
  return true;
}

}  // namespace scarab::bridge::amosii
