#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/mcap/bytes.hpp"

namespace scarab::logger {

/// What a topic means to the recorder beyond its bytes.
enum class TopicRole {
  kNone,      ///< somebody else's: nobody waits for its being recorded
  kChain,     ///< one of the project's own
  kProgress,  ///< its samples say how far the trial has been recorded: scarab/robot_state
  kTrial,     ///< its samples announce trials: scarab/trial
};

/// A topic to be recorded: what its channel and schema in the file will say.
struct ChannelSpec {
  std::string topic;
  std::string type_name;
  std::string idl;  ///< empty: the type is not known, its samples are recorded as bytes only
  TopicRole role = TopicRole::kNone;
  std::map<std::string, std::string> metadata;  ///< of the channel
};

/// Samples that will not be in the file.
struct Loss {
  std::uint64_t dropped = 0;  ///< by the recorder: its queue was full
  std::uint64_t lost = 0;     ///< by the bus: never delivered, or rejected

  Loss& operator+=(const Loss& more) {
    dropped += more.dropped;
    lost += more.lost;
    return *this;
  }
};

/// Samples on their way from the bus to the file, in the order they were taken. One allocation for
/// many samples.
class SampleBatch {
 public:
  struct Entry {
    std::uint32_t channel = 0;  ///< counted from 0 in the order the channels were added
    std::uint32_t sequence = 0;
    std::uint64_t log_time_ns = 0;
    std::uint64_t publish_time_ns = 0;
    std::size_t begin = 0;
    std::size_t size = 0;
  };

  void add_channel(ChannelSpec spec) { channels_.push_back(std::move(spec)); }
  void add(Entry entry, mcap::ByteView bytes) {
    entry.begin = bytes_.size();
    entry.size = bytes.size();
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    entries_.push_back(entry);
  }
  void add_loss(std::uint32_t channel, const Loss& loss) { losses_[channel] += loss; }

  /// Lets go of the samples of all channels but those to `keep`, and counts them as dropped.
  void drop_samples(const std::function<bool(std::uint32_t channel)>& keep);
  /// Takes over the channels and losses of a batch without samples.
  void absorb(SampleBatch&& later);

  bool empty() const { return channels_.empty() && entries_.empty() && losses_.empty(); }
  /// What it holds in memory, for the queue's bound.
  std::size_t size_bytes() const { return bytes_.size() + entries_.size() * sizeof(Entry); }
  /// Channels that are new with this batch, to be added before its samples.
  const std::vector<ChannelSpec>& channels() const { return channels_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// By channel.
  const std::map<std::uint32_t, Loss>& losses() const { return losses_; }
  mcap::ByteView bytes(const Entry& entry) const {
    return mcap::ByteView(bytes_).slice(entry.begin, entry.size);
  }

 private:
  std::vector<ChannelSpec> channels_;
  std::vector<Entry> entries_;
  std::map<std::uint32_t, Loss> losses_;
  mcap::Bytes bytes_;
};

}  // namespace scarab::logger
