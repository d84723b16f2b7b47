#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

namespace scarab::log {

/// When each moment of a log is due by this process's clock.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  /// `speed`: how many times as fast as recorded; nothing: everything is due at once.
  explicit Pace(std::optional<double> speed) : speed_(speed) {}

  /// The moment `time_ns` of the log is now.
  void start(std::uint64_t time_ns, Clock::time_point now) {
    begin_ns_ = time_ns;
    begin_ = now;
  }
  /// When the moment `time_ns` of the log is due.
  Clock::time_point due(std::uint64_t time_ns) const {
    if (!speed_ || time_ns <= begin_ns_) return begin_;
    constexpr double kNeverNs = 1e18;  // 32 years: what a clock has room for
    const double since_ns = std::min(static_cast<double>(time_ns - begin_ns_) / *speed_, kNeverNs);
    return begin_ + std::chrono::nanoseconds(static_cast<std::int64_t>(since_ns));
  }

 private:
  std::optional<double> speed_;
  std::uint64_t begin_ns_ = 0;
  Clock::time_point begin_{};
};

}  // namespace scarab::log
