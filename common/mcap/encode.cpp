#include "common/mcap/encode.hpp"

#include <limits>

#include "common/mcap/crc32.hpp"
#include "common/mcap/error.hpp"

namespace scarab::mcap {
namespace {

template <class Int>
void put(Bytes& out, Int value) {
  for (std::size_t byte = 0; byte < sizeof(Int); ++byte) {
    out.push_back(static_cast<std::uint8_t>(value >> (8U * byte)));
  }
}

void put_bytes(Bytes& out, ByteView bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

std::uint32_t checked_length(std::size_t size) {
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw FormatError("a string, array or map longer than 4 GiB does not fit into an MCAP record");
  }
  return static_cast<std::uint32_t>(size);
}

void put(Bytes& out, const std::string& text) {
  put(out, checked_length(text.size()));
  put_bytes(out, std::string_view(text));
}

/// Overwrites the little-endian integer at `at`, written before its value was known.
template <class Int>
void patch(Bytes& out, std::size_t at, Int value) {
  for (std::size_t byte = 0; byte < sizeof(Int); ++byte) {
    out[at + byte] = static_cast<std::uint8_t>(value >> (8U * byte));
  }
}

template <class Key, class Value>
void put(Bytes& out, const std::map<Key, Value>& map) {
  const std::size_t length_at = out.size();
  put(out, std::uint32_t{0});
  for (const auto& [key, value] : map) {
    put(out, key);
    put(out, value);
  }
  patch(out, length_at, checked_length(out.size() - length_at - sizeof(std::uint32_t)));
}

/// Writes opcode and a length that `end()` fills in.
class Record {
 public:
  Record(Bytes& out, Opcode opcode) : out_(out) {
    out_.push_back(static_cast<std::uint8_t>(opcode));
    length_at_ = out_.size();
    put(out_, std::uint64_t{0});
  }
  std::size_t content_at() const { return length_at_ + sizeof(std::uint64_t); }
  void end() { patch(out_, length_at_, std::uint64_t{out_.size() - content_at()}); }

 private:
  Bytes& out_;
  std::size_t length_at_ = 0;
};

/// A record whose content is the given fields, one after the other.
template <class... Fields>
void put_record(Bytes& out, Opcode opcode, const Fields&... fields) {
  Record record(out, opcode);
  (put(out, fields), ...);
  record.end();
}

}  // namespace

void encode(Bytes& out, const Header& r) { put_record(out, Opcode::kHeader, r.profile, r.library); }

void encode(Bytes& out, const Footer& r) {
  put_record(out, Opcode::kFooter, r.summary_start, r.summary_offset_start, r.summary_crc);
}

void encode(Bytes& out, const Schema& r) {
  put_record(out, Opcode::kSchema, r.id, r.name, r.encoding, r.data);
}

void encode(Bytes& out, const Channel& r) {
  put_record(out, Opcode::kChannel, r.id, r.schema_id, r.topic, r.message_encoding, r.metadata);
}

void encode(Bytes& out, const Message& r) {
  Record record(out, Opcode::kMessage);
  put(out, r.channel_id);
  put(out, r.sequence);
  put(out, r.log_time_ns);
  put(out, r.publish_time_ns);
  put_bytes(out, r.data);
  record.end();
}

void encode(Bytes& out, const Chunk& r) {
  Record record(out, Opcode::kChunk);
  put(out, r.start_time_ns);
  put(out, r.end_time_ns);
  put(out, r.uncompressed_size);
  put(out, r.uncompressed_crc);
  put(out, r.compression);
  put(out, std::uint64_t{r.records.size()});
  put_bytes(out, r.records);
  record.end();
}

void encode(Bytes& out, const ChunkIndex& r) {
  put_record(out, Opcode::kChunkIndex, r.start_time_ns, r.end_time_ns, r.offset, r.length,
             r.message_index_offsets, r.message_index_length, r.compression, r.compressed_size,
             r.uncompressed_size);
}

void encode(Bytes& out, const Attachment& r) {
  Record record(out, Opcode::kAttachment);
  put(out, r.log_time_ns);
  put(out, r.create_time_ns);
  put(out, r.name);
  put(out, r.media_type);
  put(out, std::uint64_t{r.data.size()});
  put_bytes(out, r.data);
  put(out, crc32(ByteView(out).slice(record.content_at(), out.size() - record.content_at())));
  record.end();
}

void encode(Bytes& out, const AttachmentIndex& r) {
  put_record(out, Opcode::kAttachmentIndex, r.offset, r.length, r.log_time_ns, r.create_time_ns,
             r.data_size, r.name, r.media_type);
}

void encode(Bytes& out, const Metadata& r) {
  put_record(out, Opcode::kMetadata, r.name, r.entries);
}

void encode(Bytes& out, const MetadataIndex& r) {
  put_record(out, Opcode::kMetadataIndex, r.offset, r.length, r.name);
}

void encode(Bytes& out, const Statistics& r) {
  put_record(out, Opcode::kStatistics, r.message_count, r.schema_count, r.channel_count,
             r.attachment_count, r.metadata_count, r.chunk_count, r.start_time_ns, r.end_time_ns,
             r.channel_message_counts);
}

void encode(Bytes& out, const SummaryOffset& r) {
  put_record(out, Opcode::kSummaryOffset, static_cast<std::uint8_t>(r.group), r.start, r.length);
}

void encode_message_index(Bytes& out, std::uint16_t channel_id, const MessageOffsets& entries) {
  constexpr std::size_t kEntrySize = 2 * sizeof(std::uint64_t);
  Record record(out, Opcode::kMessageIndex);
  put(out, channel_id);
  put(out, checked_length(entries.size() * kEntrySize));
  for (const auto& [log_time_ns, offset] : entries) {
    put(out, log_time_ns);
    put(out, offset);
  }
  record.end();
}

void encode_data_end(Bytes& out, std::uint32_t data_section_crc) {
  put_record(out, Opcode::kDataEnd, data_section_crc);
}

Bytes footer_before_crc(const Footer& footer) {
  Bytes out;
  encode(out, footer);
  out.resize(out.size() - sizeof(footer.summary_crc));
  return out;
}

}  // namespace scarab::mcap
