#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "common/bus/profile.hpp"

namespace scarab::runtime {

/// Lockstep: when the samples of the streams (robot_sensors, world_state) leave. Nobody is in a
/// hurry for them, and each packet costs the chain: those of a few ticks leave together, while the
/// chain works on a tick.
class StreamBatch {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::uint32_t kTicks = 4;
  static constexpr std::chrono::milliseconds kLongest{20};  ///< they are kept back

  /// Of streams with so many samples a tick.
  explicit StreamBatch(std::uint32_t samples_per_tick)
      : kept_ticks_(std::min(bus::kDepth, bus::kStreamDepth / std::max(1U, samples_per_tick))),
        ticks_(kept_ticks_ > 4 * kTicks ? kTicks : 1) {}

  /// Ticks whose samples leave together: one where the writers keep those of a few ticks only.
  [[nodiscard]] std::uint32_t ticks() const { return ticks_; }

  /// Ticks that the chain may be ahead of who is to get every sample, so that nothing he lacks is
  /// overwritten in the writers: all they keep but the running tick and those that are kept back.
  [[nodiscard]] std::uint32_t lead() const {
    return std::max(kept_ticks_, ticks_ + 2) - ticks_ - 1;
  }

  [[nodiscard]] bool due(std::uint32_t tick, Clock::time_point now) const {
    return tick % ticks_ == 0 || now - sent_ >= kLongest;
  }
  void sent(Clock::time_point now) { sent_ = now; }

 private:
  std::uint32_t kept_ticks_;  // by writers
  std::uint32_t ticks_;
  Clock::time_point sent_{};
};

}  // namespace scarab::runtime
