#include "services/logger/stack_watch.hpp"

#include <algorithm>

#include "services/logger/core/sample_header.hpp"

namespace scarab::logger {

void StackWatch::note(const SampleBatch& batch, Clock::time_point now) {
  for (const ChannelSpec& spec : batch.channels()) roles_.push_back(spec.role);
  for (const SampleBatch::Entry& entry : batch.entries()) {
    const TopicRole role = roles_.at(entry.channel);
    if (role == TopicRole::kProgress || role == TopicRole::kTrial) {
      note(role, batch.bytes(entry), now);
    }
  }
}

void StackWatch::note(TopicRole role, mcap::ByteView bytes, Clock::time_point now) {
  const auto header = read_sample_header(bytes.data(), bytes.size());
  if (!header) return;
  if (role == TopicRole::kTrial) {
    trial_ = std::max(trial_, header->trial);
  } else if (const auto flags = read_state_flags(bytes.data(), bytes.size())) {
    state_trial_ = header->trial;
    flags_ = *flags;
    if (flags_.over) over_since_ = now;
  }
}

bool StackWatch::in_lockstep(Clock::time_point now) const {
  const bool over = flags_.over && now - over_since_ > kAftermath;
  return !flags_.real_time && state_trial_ == trial_ && !over;
}

}  // namespace scarab::logger
