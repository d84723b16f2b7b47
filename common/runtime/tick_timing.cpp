#include "common/runtime/tick_timing.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "common/bus/clock.hpp"
#include "common/runtime/real_time_care.hpp"

namespace scarab::runtime {

void TickTiming::answered(TimePoint now, bool late) {
  command_age_.add(now - asked_at_);
  if (late) ++late_commands_;
}

void TickTiming::report(const TickPacer& pacer, StatusPublisher& status) {
  status.set_histogram("command_age", command_age_);
  if (const auto jump = clock_watch_.look(std::chrono::nanoseconds(bus::now_ns()),
                                          std::chrono::steady_clock::now().time_since_epoch())) {
    ++clock_jumps_;
    status.set_health(
        scarab_HEALTH_DEGRADED,
        fmt::format("the system clock was set by {:+.3f} s: stamps before and after do not compare",
                    std::chrono::duration<double>(*jump).count()));
  }
  status.set_counter("clock_jumps", clock_jumps_);
  if (!real_time_) return;
  status.set_histogram("tick_cycle", pacer.cycle());
  status.set_histogram("tick_jitter", pacer.jitter());
  status.set_histogram("tick_overrun", pacer.overrun());
  status.set_counter("commands_late", late_commands_);
}

void take_care_of_real_time(StatusPublisher& status) {
  const RealTimeCare care = take_real_time_care();
  status.set_counter("memory_locked", care.memory_locked ? 1 : 0);
  status.set_counter("priority_raised", care.priority_raised ? 1 : 0);
  for (const auto& refusal : {care.memory_refusal, care.priority_refusal}) {
    if (!refusal.empty()) spdlog::warn("real time: {}", refusal);
  }
}

}  // namespace scarab::runtime
