#include "common/mcap/decode.hpp"

#include "common/mcap/crc32.hpp"
#include "common/mcap/error.hpp"

namespace scarab::mcap {
namespace {

/// Takes little-endian fields off the front; throws FormatError when they are not there.
class Fields {
 public:
  explicit Fields(ByteView bytes) : bytes_(bytes) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }

  ByteView take(std::uint64_t size) {
    if (size > left()) {
      throw FormatError("malformed MCAP record: a length leads beyond its end");
    }
    const ByteView taken = bytes_.slice(position_, static_cast<std::size_t>(size));
    position_ += taken.size();
    return taken;
  }

  template <class Int>
  void get(Int& value) {
    const ByteView taken = take(sizeof(Int));
    value = 0;
    for (std::size_t byte = sizeof(Int); byte > 0; --byte) {
      value = static_cast<Int>((std::uint64_t{value} << 8U) | taken[byte - 1]);
    }
  }

  void get(std::string& text) {
    const ByteView taken = take(integer<std::uint32_t>());
    text.assign(taken.begin(), taken.end());
  }

  template <class Key, class Value>
  void get(std::map<Key, Value>& map) {
    Fields entries(take(integer<std::uint32_t>()));
    while (entries.left() > 0) {
      Key key{};
      entries.get(key);
      entries.get(map[key]);
    }
  }

  template <class Int>
  Int integer() {
    Int value = 0;
    get(value);
    return value;
  }

  template <class... Values>
  void get_all(Values&... values) {
    (get(values), ...);
  }

 private:
  ByteView bytes_;
  std::size_t position_ = 0;
};

}  // namespace

Header decode_header(ByteView content) {
  Header r;
  Fields(content).get_all(r.profile, r.library);
  return r;
}

Footer decode_footer(ByteView content) {
  Footer r;
  Fields(content).get_all(r.summary_start, r.summary_offset_start, r.summary_crc);
  return r;
}

Schema decode_schema(ByteView content) {
  Schema r;
  Fields(content).get_all(r.id, r.name, r.encoding, r.data);
  return r;
}

Channel decode_channel(ByteView content) {
  Channel r;
  Fields(content).get_all(r.id, r.schema_id, r.topic, r.message_encoding, r.metadata);
  return r;
}

Message decode_message(ByteView content) {
  Message r;
  Fields fields(content);
  fields.get_all(r.channel_id, r.sequence, r.log_time_ns, r.publish_time_ns);
  r.data = fields.take(fields.left());
  return r;
}

Chunk decode_chunk(ByteView content) {
  Chunk r;
  Fields fields(content);
  fields.get_all(r.start_time_ns, r.end_time_ns, r.uncompressed_size, r.uncompressed_crc,
                 r.compression);
  r.records = fields.take(fields.integer<std::uint64_t>());
  return r;
}

ChunkIndex decode_chunk_index(ByteView content) {
  ChunkIndex r;
  Fields(content).get_all(r.start_time_ns, r.end_time_ns, r.offset, r.length,
                          r.message_index_offsets, r.message_index_length, r.compression,
                          r.compressed_size, r.uncompressed_size);
  return r;
}

Attachment decode_attachment(ByteView content) {
  Attachment r;
  Fields fields(content);
  fields.get_all(r.log_time_ns, r.create_time_ns, r.name, r.media_type);
  r.data = copy_of(fields.take(fields.integer<std::uint64_t>()));
  const ByteView covered = content.slice(0, fields.position());
  const auto crc = fields.integer<std::uint32_t>();
  if (crc != 0 && crc != crc32(covered)) {
    throw FormatError("attachment " + r.name + ": its CRC does not match its content");
  }
  return r;
}

AttachmentIndex decode_attachment_index(ByteView content) {
  AttachmentIndex r;
  Fields(content).get_all(r.offset, r.length, r.log_time_ns, r.create_time_ns, r.data_size, r.name,
                          r.media_type);
  return r;
}

Metadata decode_metadata(ByteView content) {
  Metadata r;
  Fields(content).get_all(r.name, r.entries);
  return r;
}

MetadataIndex decode_metadata_index(ByteView content) {
  MetadataIndex r;
  Fields(content).get_all(r.offset, r.length, r.name);
  return r;
}

Statistics decode_statistics(ByteView content) {
  Statistics r;
  Fields(content).get_all(r.message_count, r.schema_count, r.channel_count, r.attachment_count,
                          r.metadata_count, r.chunk_count, r.start_time_ns, r.end_time_ns,
                          r.channel_message_counts);
  return r;
}

SummaryOffset decode_summary_offset(ByteView content) {
  SummaryOffset r;
  Fields fields(content);
  r.group = static_cast<Opcode>(fields.integer<std::uint8_t>());
  fields.get_all(r.start, r.length);
  return r;
}

std::uint32_t decode_data_end(ByteView content) { return Fields(content).integer<std::uint32_t>(); }

MessageIndex decode_message_index(ByteView content) {
  MessageIndex r;
  Fields fields(content);
  fields.get(r.channel_id);
  Fields entries(fields.take(fields.integer<std::uint32_t>()));
  while (entries.left() > 0) {
    auto& [log_time_ns, offset] = r.entries.emplace_back();
    entries.get_all(log_time_ns, offset);
  }
  return r;
}

RecordPrefix decode_prefix(ByteView bytes) {
  Fields fields(bytes);
  RecordPrefix prefix;
  prefix.opcode = static_cast<Opcode>(fields.integer<std::uint8_t>());
  fields.get(prefix.length);
  return prefix;
}

bool RecordCursor::next() {
  offset_ = next_;
  if (offset_ == bytes_.size()) {
    return false;
  }
  Fields fields(bytes_.slice(offset_, bytes_.size() - offset_));
  opcode_ = static_cast<Opcode>(fields.integer<std::uint8_t>());
  content_ = fields.take(fields.integer<std::uint64_t>());
  next_ = offset_ + fields.position();
  return true;
}

}  // namespace scarab::mcap
