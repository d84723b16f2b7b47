#pragma once

#include <chrono>
#include <cstdint>

namespace scarab::bus {

/// The wall clock, ns since the Unix epoch: the clock of DDS timestamps and of Header.stamp_ns.
inline std::int64_t now_ns() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

}  // namespace scarab::bus
