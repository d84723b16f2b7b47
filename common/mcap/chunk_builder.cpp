#include "common/mcap/chunk_builder.hpp"

#include <algorithm>

#include "common/mcap/crc32.hpp"

namespace scarab::mcap {

void ChunkBuilder::add(const Message& message) {
  const bool first = index_.empty();
  start_time_ns_ = first ? message.log_time_ns : std::min(start_time_ns_, message.log_time_ns);
  end_time_ns_ = first ? message.log_time_ns : std::max(end_time_ns_, message.log_time_ns);
  index_[message.channel_id].emplace_back(message.log_time_ns, records_.size());
  encode(records_, message);
}

ChunkIndex ChunkBuilder::finish(Bytes& out, std::uint64_t offset, Compression compression,
                                int level) {
  const Bytes compressed = compress(compression, level, records_);
  encode(out, Chunk{start_time_ns_, end_time_ns_, records_.size(), crc32(records_),
                    name_of(compression), compressed});
  ChunkIndex index;
  index.start_time_ns = start_time_ns_;
  index.end_time_ns = end_time_ns_;
  index.offset = offset;
  index.length = out.size();
  index.compression = name_of(compression);
  index.compressed_size = compressed.size();
  index.uncompressed_size = records_.size();
  for (const auto& [channel_id, entries] : index_) {
    index.message_index_offsets[channel_id] = offset + out.size();
    encode_message_index(out, channel_id, entries);
  }
  index.message_index_length = out.size() - index.length;
  records_.clear();
  index_.clear();
  start_time_ns_ = end_time_ns_ = 0;
  return index;
}

}  // namespace scarab::mcap
