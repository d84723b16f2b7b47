#include "services/logger/sample_batch.hpp"

#include <iterator>

namespace scarab::logger {

void SampleBatch::drop_samples(const std::function<bool(std::uint32_t channel)>& keep) {
  const auto entries = std::exchange(entries_, {});
  const auto all_bytes = std::exchange(bytes_, {});
  for (const Entry& entry : entries) {
    if (keep(entry.channel)) {
      add(entry, mcap::ByteView(all_bytes).slice(entry.begin, entry.size));
    } else {
      ++losses_[entry.channel].dropped;
    }
  }
}

void SampleBatch::absorb(SampleBatch&& later) {
  channels_.insert(channels_.end(), std::make_move_iterator(later.channels_.begin()),
                   std::make_move_iterator(later.channels_.end()));
  for (const auto& [channel, loss] : later.losses_) {
    losses_[channel] += loss;
  }
}

}  // namespace scarab::logger
