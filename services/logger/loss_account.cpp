#include "services/logger/loss_account.hpp"

namespace scarab::logger {

void LossAccount::note(const SampleBatch& batch) {
  for (const ChannelSpec& spec : batch.channels()) topics_.push_back(spec.topic);
  for (const auto& [channel, loss] : batch.losses()) {
    by_topic_[topics_.at(channel)] += loss;
    total_ += loss;
  }
}

std::string LossAccount::dropped_in_words() const {
  if (total_.dropped == 0) return "";
  std::string topics;
  for (const auto& [topic, loss] : by_topic_) {
    if (loss.dropped == 0) continue;
    topics += (topics.empty() ? "" : ", ") + topic + " " + std::to_string(loss.dropped);
  }
  return std::to_string(total_.dropped) + " samples dropped (" + topics +
         "): they came faster than they could be written";
}

}  // namespace scarab::logger
