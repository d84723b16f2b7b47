#pragma once

#include <chrono>
#include <cstdint>

#include "common/runtime/clock_watch.hpp"
#include "common/runtime/histogram.hpp"
#include "common/runtime/status_publisher.hpp"
#include "common/runtime/tick_pacer.hpp"

namespace scarab::runtime {

/// How well a tick master keeps time: measured tick by tick, shown in service_status.
class TickTiming {
 public:
  using TimePoint = TickPacer::TimePoint;

  explicit TickTiming(bool real_time) : real_time_(real_time) {}

  /// robot_state of a tick goes out.
  void asked(TimePoint now) { asked_at_ = now; }
  /// The tick's command has been accepted; `late`: after its deadline.
  void answered(TimePoint now, bool late);
  /// Shows all of it. A system clock that was set since the last report is a degraded health.
  void report(const TickPacer& pacer, StatusPublisher& status);

 private:
  bool real_time_;
  TimePoint asked_at_{};
  Histogram command_age_;  // from robot_state to the command accepted for it
  std::uint64_t late_commands_ = 0;
  ClockWatch clock_watch_;
  std::uint64_t clock_jumps_ = 0;
};

/// Asks the system for what real time needs, and shows and logs what it refuses.
void take_care_of_real_time(StatusPublisher& status);

}  // namespace scarab::runtime
