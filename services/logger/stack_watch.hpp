#pragma once

#include <cstdint>
#include <map>

#include "services/logger/core/recorded_progress.hpp"
#include "services/logger/core/state_flags.hpp"
#include "services/logger/sample_batch.hpp"

namespace scarab::logger {

/// What the samples on their way to the file say of the stack: the trial it is in, and whether it
/// waits for the recorder.
class StackWatch {
 public:
  void note(const SampleBatch& batch);

  /// The one announced last; 0 before the first.
  std::uint32_t trial() const { return trial_; }
  /// The trial runs in lockstep and is not recorded to its end: who waits now loses nothing.
  bool in_lockstep(const RecordedProgress& recorded) const;

 private:
  void note(TopicRole role, mcap::ByteView bytes);

  std::uint32_t channel_count_ = 0;
  std::map<std::uint32_t, TopicRole> roles_;  // of channels that have one
  std::uint32_t trial_ = 0;
  SampleHeader newest_state_;
  StateFlags flags_{false, true};
};

}  // namespace scarab::logger
