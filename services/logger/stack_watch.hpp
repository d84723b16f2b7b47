#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "services/logger/core/state_flags.hpp"
#include "services/logger/sample_batch.hpp"

namespace scarab::logger {

/// What the samples on their way to the file say of the stack: the trial it is in, and whether it
/// waits for the recorder.
class StackWatch {
 public:
  using Clock = std::chrono::steady_clock;

  void note(const SampleBatch& batch, Clock::time_point now);

  /// The one announced last; 0 before the first.
  std::uint32_t trial() const { return trial_; }
  /// A trial runs whose tick master waits for the recorder, or has just ended: answers to its last
  /// tick may be on their way.
  bool in_lockstep(Clock::time_point now) const;
  TopicRole role_of(std::uint32_t channel) const { return roles_.at(channel); }

 private:
  static constexpr std::chrono::seconds kAftermath{1};

  void note(TopicRole role, mcap::ByteView bytes, Clock::time_point now);

  std::vector<TopicRole> roles_;  // by channel
  std::uint32_t trial_ = 0;
  std::uint32_t state_trial_ = 0;  // of the newest robot_state
  StateFlags flags_{false, true};
  Clock::time_point over_since_{};
};

}  // namespace scarab::logger
