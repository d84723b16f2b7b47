#include "services/robot_bridge/drivers/amosii/protocol/parsers.hpp"

namespace scarab::bridge::amosii {

std::optional<CommandParser::Command> CommandParser::push(std::uint8_t byte) {
  window_.push(byte);
  if (byte != kTerminator) return std::nullopt;
  constexpr std::size_t kLastAge = std::tuple_size_v<SetFrame> - 1;
  if (window_.count() > kLastAge && window_.back(kLastAge) == kSetCommand) {
    const Slots motors = window_.slots();
    if (is_plausible_set(motors)) {
      window_.clear();
      return motors;
    }
    ++implausible_sets_;
  }
  if (window_.count() > 1 && window_.back(1) == kGetCommand) {
    window_.clear();
    return Get{};
  }
  return std::nullopt;
}

std::optional<Slots> ReplyParser::push(std::uint8_t byte) {
  window_.push(byte);
  ++pending_;
  if (byte != kTerminator || window_.count() <= kSlotCount) return std::nullopt;
  const Slots sensors = window_.slots();
  if (!is_plausible_reply(sensors)) return std::nullopt;
  expect();
  return sensors;
}

void ReplyParser::expect() {
  window_.clear();
  pending_ = 0;
}

}  // namespace scarab::bridge::amosii
