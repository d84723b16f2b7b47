#include "services/logger/stack_watch.hpp"

#include <algorithm>

namespace scarab::logger {

void StackWatch::note(const SampleBatch& batch) {
  for (const ChannelSpec& spec : batch.channels()) {
    if (spec.role != TopicRole::kNone) roles_[channel_count_] = spec.role;
    ++channel_count_;
  }
  if (roles_.empty()) return;
  for (const SampleBatch::Entry& entry : batch.entries()) {
    const auto role = roles_.find(entry.channel);
    if (role != roles_.end()) note(role->second, batch.bytes(entry));
  }
}

void StackWatch::note(TopicRole role, mcap::ByteView bytes) {
  const auto header = read_sample_header(bytes.data(), bytes.size());
  if (!header) return;
  if (role == TopicRole::kTrial) {
    trial_ = std::max(trial_, header->trial);
  } else if (const auto flags = read_state_flags(bytes.data(), bytes.size())) {
    newest_state_ = *header;
    flags_ = *flags;
  }
}

bool StackWatch::in_lockstep(const RecordedProgress& recorded) const {
  if (flags_.real_time || newest_state_.trial != trial_) return false;
  const bool recorded_to_its_end =
      flags_.over && recorded.trial() == trial_ && recorded.tick() >= newest_state_.tick;
  return !recorded_to_its_end;
}

}  // namespace scarab::logger
