#pragma once

#include <chrono>
#include <optional>

#include "common/runtime/histogram.hpp"

namespace scarab::runtime {

/// Keeps ticks to the wall clock and measures how well that goes. Times come from outside, so that
/// it can be tested without waiting.
class TickPacer {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  explicit TickPacer(std::chrono::nanoseconds period) : period_(period) {}

  /// The next tick is due now: at the start of a trial and after a pause.
  void restart(TimePoint now) {
    due_ = now;
    begun_.reset();
  }
  /// When the present tick is due; it lasts a period.
  [[nodiscard]] TimePoint due() const { return due_; }
  [[nodiscard]] TimePoint end() const { return due_ + period_; }

  void tick_begins(TimePoint now);
  /// The tick's work is done; the next is due at end(). Lateness of more than a period is not
  /// caught up with: that would send the robot a burst of ticks.
  void tick_ends(TimePoint now);

  /// From the beginning of each tick to that of the next.
  [[nodiscard]] const Histogram& cycle() const { return cycle_; }
  /// How late each tick began.
  [[nodiscard]] const Histogram& jitter() const { return jitter_; }
  /// By how much the work of those ticks that overran their period did so.
  [[nodiscard]] const Histogram& overrun() const { return overrun_; }

 private:
  std::chrono::nanoseconds period_;
  TimePoint due_{};
  std::optional<TimePoint> begun_;  // the tick before, unless there was a restart between
  Histogram cycle_;
  Histogram jitter_;
  Histogram overrun_;
};

}  // namespace scarab::runtime
