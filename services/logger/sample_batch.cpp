#include "services/logger/sample_batch.hpp"

#include <iterator>

namespace scarab::logger {

void SampleBatch::drop_samples() {
  for (const Entry& entry : entries_) {
    ++losses_[entry.channel].dropped;
  }
  entries_ = {};
  bytes_ = {};
}

void SampleBatch::absorb(SampleBatch&& later) {
  channels_.insert(channels_.end(), std::make_move_iterator(later.channels_.begin()),
                   std::make_move_iterator(later.channels_.end()));
  for (const auto& [channel, loss] : later.losses_) {
    losses_[channel] += loss;
  }
}

}  // namespace scarab::logger
