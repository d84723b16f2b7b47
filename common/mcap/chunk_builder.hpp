#pragma once

#include <cstdint>
#include <map>

#include "common/mcap/compression.hpp"
#include "common/mcap/encode.hpp"

namespace scarab::mcap {

/// Collects the records of one chunk in memory, with the index of its messages.
class ChunkBuilder {
 public:
  void add(const Schema& schema) { encode(records_, schema); }
  void add(const Channel& channel) { encode(records_, channel); }
  void add(const Message& message);

  bool empty() const { return records_.empty(); }
  /// Bytes before compression.
  std::size_t size() const { return records_.size(); }
  /// Earliest and latest log time of its messages.
  std::uint64_t start_time_ns() const { return start_time_ns_; }
  std::uint64_t end_time_ns() const { return end_time_ns_; }

  /// Appends the chunk record and one index record for each channel to `out`, whose first byte
  /// stands at `offset` in the file; returns where they are and empties the builder.
  ChunkIndex finish(Bytes& out, std::uint64_t offset, Compression compression, int level);

 private:
  Bytes records_;
  std::map<std::uint16_t, MessageOffsets> index_;
  std::uint64_t start_time_ns_ = 0;
  std::uint64_t end_time_ns_ = 0;
};

}  // namespace scarab::mcap
