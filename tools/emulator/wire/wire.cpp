#include "tools/emulator/wire/wire.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::emulator {
namespace {

constexpr double kNsPerS = 1e9;

}  // namespace

Wire::Wire(const std::filesystem::path& link, unsigned baud, std::uint64_t seed)
    : port_(link),
      in_(LineRate(baud)),
      out_(LineRate(baud)),
      noise_in_(seed, "to the board"),
      noise_out_(seed, "from the board") {}

void Wire::suffer(const Effects& effects) {
  effects_ = effects;
  if (effects.unplugged && port_.is_plugged()) {
    port_.unplug();
    in_.clear();
    out_.clear();
  }
  if (!effects.unplugged) port_.plug();
}

void Wire::carry_in(std::int64_t now_ns, Board& board) {
  in_.send(port_.read(), now_ns);
  std::vector<Reply> replies;
  while (const auto arrival = in_.take(now_ns)) {
    const auto byte = noise_in_.pass(arrival->byte, effects_.lose, effects_.flip);
    if (!byte || effects_.board_silent) continue;
    replies.clear();
    board.on_byte(*byte, arrival->time_ns, replies);
    std::int64_t from_ns = arrival->time_ns + std::llround(effects_.late_s * kNsPerS);
    for (const Reply& reply : replies) from_ns = out_.send(reply.bytes, from_ns + reply.delay_ns);
  }
}

void Wire::carry_out(std::int64_t now_ns) {
  std::vector<std::uint8_t> bytes;
  while (const auto arrival = out_.take(now_ns)) {
    const auto byte = noise_out_.pass(arrival->byte, effects_.lose, effects_.flip);
    if (byte) bytes.push_back(*byte);
  }
  (void)port_.write(bytes);
}

std::optional<std::int64_t> Wire::next_ns() const {
  const auto in_ns = in_.frame_end_ns();
  const auto out_ns = out_.frame_end_ns();
  if (!in_ns || !out_ns) return in_ns ? in_ns : out_ns;
  return std::min(*in_ns, *out_ns);
}

}  // namespace scarab::emulator
