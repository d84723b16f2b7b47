#include "services/robot_bridge/drivers/amosii/board.hpp"

#include <algorithm>
#include <array>
#include <thread>

namespace scarab::bridge::amosii {
namespace {

using serial::Clock;

/// A line that takes no bytes for so long is stuck: it is emptied at the baud rate.
constexpr Clock::duration kWriteTimeout = std::chrono::milliseconds(50);

/// What has arrived is read even when the deadline has passed meanwhile, but of a line that never
/// falls silent no more than this.
constexpr std::size_t kFlood = 512;

Clock::duration wire_time(std::size_t size) {
  return std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(wire_time_s(size)));
}

}  // namespace

Board::Board(const std::string& port, const Manners& manners, BoardCounters& counters)
    : port_(port, kBaud), manners_(manners), counters_(&counters) {}

void Board::set(const Slots& motors) {
  std::this_thread::sleep_until(busy_until_ + manners_.pause);
  const SetFrame frame = encode_set(motors);
  port_.write(frame, Clock::now() + kWriteTimeout);
  busy_until_ = Clock::now() + wire_time(frame.size());
  set_busy_until_ = busy_until_;
  ++counters_->sets;
}

std::optional<Slots> Board::reply_until(serial::Deadline deadline) {
  std::array<std::uint8_t, 64> bytes{};
  std::size_t size = port_.read_some(bytes, deadline);
  while (size > 0) {
    for (std::size_t i = 0; i < size; ++i) {
      if (const auto reply = parser_.push(bytes[i])) {
        ++counters_->replies;
        return reply;
      }
    }
    // As much as a reply came, or its end a byte too early. What may still come is a reply behind
    // the end of an older one, and that would be here soon.
    const bool is_short = parser_.pending() == kSlotCount && bytes[size - 1] == kTerminator;
    if (is_short || parser_.pending() > kSlotCount) {
      deadline = std::min(deadline, Clock::now() + wire_time(std::tuple_size_v<ReplyFrame>));
    }
    size = parser_.pending() < kFlood ? port_.read_some(bytes, deadline) : 0;
  }
  const bool is_damaged = parser_.pending() >= kSlotCount;
  ++(is_damaged ? counters_->replies_damaged : counters_->replies_missing);
  return std::nullopt;
}

Slots Board::get() {
  std::this_thread::sleep_until(set_busy_until_ + manners_.pause);
  for (unsigned attempt = 0; attempt < manners_.attempts; ++attempt) {
    port_.discard_input();
    parser_.expect();
    port_.write(kGetFrame, Clock::now() + kWriteTimeout);
    ++counters_->gets;
    const auto reply = reply_until(Clock::now() + manners_.reply_timeout);
    busy_until_ = std::max(busy_until_, Clock::now());
    if (reply) return *reply;
  }
  throw DeviceError(port_.path() + ": the board has not answered, asked " +
                    std::to_string(manners_.attempts) + " times" +
                    (parser_.pending() == 0 ? "" : " (what came was no reply)"));
}

}  // namespace scarab::bridge::amosii
