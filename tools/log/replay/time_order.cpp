#include "tools/log/replay/time_order.hpp"

#include <algorithm>
#include <tuple>

namespace scarab::log {

namespace {

bool is_later(const TimedMessage& a, const TimedMessage& b) {
  return std::tie(a.time_ns, a.position) > std::tie(b.time_ns, b.position);
}

}  // namespace

std::uint64_t time_of(const mcap::Message& message) {
  const std::uint64_t publish = message.publish_time_ns;
  const std::uint64_t log = message.log_time_ns;
  return publish <= log && log - publish <= TimeOrder::kWindow ? publish : log;
}

bool TimeOrder::push(const LogChannel& channel, const mcap::Message& message) {
  held_.push_back({&channel, time_of(message), message.publish_time_ns, next_position_++,
                   mcap::copy_of(message.data)});
  std::push_heap(held_.begin(), held_.end(), is_later);
  newest_ns_ = std::max(newest_ns_, message.log_time_ns);
  return emit_until(newest_ns_ - std::min(newest_ns_, kWindow));
}

bool TimeOrder::flush() { return emit_until(UINT64_MAX); }

bool TimeOrder::emit_until(std::uint64_t time_ns) {
  while (!held_.empty() && held_.front().time_ns <= time_ns) {
    std::pop_heap(held_.begin(), held_.end(), is_later);
    TimedMessage message = std::move(held_.back());
    held_.pop_back();
    if (!visit_(message)) return false;
  }
  return true;
}

}  // namespace scarab::log
