#include "services/logger/loss_account.hpp"

namespace scarab::logger {

void LossAccount::note(const SampleBatch& batch) {
  for (const ChannelSpec& spec : batch.channels()) topics_.push_back(spec.topic);
  for (const auto& [channel, loss] : batch.losses()) {
    by_topic_[topics_.at(channel)] += loss;
    total_ += loss;
  }
}

std::vector<std::string> LossAccount::in_words() const {
  std::vector<std::string> words;
  const auto add = [&](std::uint64_t Loss::*count, const std::string& how) {
    if (total_.*count == 0) return;
    std::string topics;
    for (const auto& [topic, loss] : by_topic_) {
      if (loss.*count == 0) continue;
      topics += (topics.empty() ? "" : ", ") + topic + " " + std::to_string(loss.*count);
    }
    words.push_back(std::to_string(total_.*count) + " samples " + how + " (" + topics + ")");
  };
  add(&Loss::dropped, "dropped: written too slowly");
  add(&Loss::lost, "lost by the bus");
  return words;
}

}  // namespace scarab::logger
