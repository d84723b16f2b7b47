#include "common/runtime/clock_watch.hpp"

namespace scarab::runtime {

std::optional<std::chrono::nanoseconds> ClockWatch::look(std::chrono::nanoseconds system,
                                                         std::chrono::nanoseconds steady) {
  const auto offset = system - steady;
  const auto jump = offset - offset_.value_or(offset);
  offset_ = offset;
  if (std::chrono::abs(jump) < kTolerance) return std::nullopt;
  return jump;
}

}  // namespace scarab::runtime
