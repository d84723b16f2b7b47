#include "tools/emulator/wire/timed_bytes.hpp"

#include <algorithm>

namespace scarab::emulator {

std::int64_t TimedBytes::send(const std::uint8_t* bytes, std::size_t count, std::int64_t from_ns) {
  const std::int64_t begin_ns = std::max(from_ns, free_ns_);
  for (std::size_t i = 0; i < count; ++i) {
    under_way_.push_back({{bytes[i], begin_ns + rate_.time_ns(i + 1)}, i + 1 == count});
  }
  free_ns_ = begin_ns + rate_.time_ns(count);
  return free_ns_;
}

std::optional<TimedBytes::Arrival> TimedBytes::take(std::int64_t now_ns) {
  if (under_way_.empty() || under_way_.front().arrival.time_ns > now_ns) return std::nullopt;
  const Arrival arrival = under_way_.front().arrival;
  under_way_.pop_front();
  return arrival;
}

std::optional<std::int64_t> TimedBytes::frame_end_ns() const {
  const auto last = std::find_if(under_way_.begin(), under_way_.end(),
                                 [](const Byte& byte) { return byte.ends_frame; });
  if (last == under_way_.end()) return std::nullopt;
  return last->arrival.time_ns;
}

void TimedBytes::clear() {
  under_way_.clear();
  free_ns_ = 0;
}

}  // namespace scarab::emulator
