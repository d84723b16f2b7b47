#include "common/mcap/scan.hpp"

#include "common/mcap/compression.hpp"
#include "common/mcap/crc32.hpp"
#include "common/mcap/error.hpp"
#include "common/mcap/record_stream.hpp"

namespace scarab::mcap {
namespace {

void add_channel(Summary& summary, ByteView content) {
  Channel channel = decode_channel(content);
  summary.channels[channel.id] = std::move(channel);
}

void add_schema(Summary& summary, ByteView content) {
  Schema schema = decode_schema(content);
  if (schema.id != 0) {  // the specification: an id of 0 is to be ignored
    summary.schemas[schema.id] = std::move(schema);
  }
}

std::string undescribed(std::uint16_t channel_id) {
  return "a message names channel " + std::to_string(channel_id) +
         ", which is not described before it";
}

void add_message(Summary& summary, const Message& message) {
  if (summary.channels.count(message.channel_id) == 0) {
    throw FormatError(undescribed(message.channel_id));
  }
  summary.statistics.count(message);
}

/// Throws FormatError unless every record of a chunk can be added.
void check_records(const Summary& summary, ByteView records) {
  std::set<std::uint16_t> described;
  RecordCursor cursor(records);
  while (cursor.next()) {
    if (cursor.opcode() == Opcode::kSchema) {
      decode_schema(cursor.content());
    } else if (cursor.opcode() == Opcode::kChannel) {
      described.insert(decode_channel(cursor.content()).id);
    } else if (cursor.opcode() == Opcode::kMessage) {
      const std::uint16_t id = decode_message(cursor.content()).channel_id;
      if (described.count(id) == 0 && summary.channels.count(id) == 0) {
        throw FormatError(undescribed(id));
      }
    }
  }
}

/// Adds a chunk to the summary, all of it or, when anything in it is wrong, nothing.
void add_chunk(Summary& summary, RecordStream& at) {
  const ByteView content = at.content();
  const Chunk chunk = decode_chunk(content);
  const Bytes records = unpack(chunk);
  check_records(summary, records);
  RecordCursor cursor(records);
  while (cursor.next()) {
    if (cursor.opcode() == Opcode::kSchema) {
      add_schema(summary, cursor.content());
    } else if (cursor.opcode() == Opcode::kChannel) {
      add_channel(summary, cursor.content());
    } else if (cursor.opcode() == Opcode::kMessage) {
      summary.statistics.count(decode_message(cursor.content()));
    }
  }
  ChunkIndex index;
  index.start_time_ns = chunk.start_time_ns;
  index.end_time_ns = chunk.end_time_ns;
  index.offset = at.offset();
  index.length = at.length();
  index.compression = chunk.compression;
  index.compressed_size = chunk.records.size();
  index.uncompressed_size = chunk.uncompressed_size;
  summary.chunks.push_back(std::move(index));
}

void add_record(Summary& summary, RecordStream& at) {
  if (at.opcode() == Opcode::kChunk) {
    add_chunk(summary, at);
  } else if (at.opcode() == Opcode::kSchema) {
    add_schema(summary, at.content());
  } else if (at.opcode() == Opcode::kChannel) {
    add_channel(summary, at.content());
  } else if (at.opcode() == Opcode::kMessage) {
    const ByteView content = at.content();
    add_message(summary, decode_message(content));
  } else if (at.opcode() == Opcode::kAttachment) {
    const Attachment a = decode_attachment(at.content());
    summary.attachments.push_back({at.offset(), at.length(), a.log_time_ns, a.create_time_ns,
                                   a.data.size(), a.name, a.media_type});
  } else if (at.opcode() == Opcode::kMetadata) {
    summary.metadata.push_back({at.offset(), at.length(), decode_metadata(at.content()).name});
  }
}

void count(Summary& summary) {
  Statistics& statistics = summary.statistics;
  statistics.schema_count = static_cast<std::uint16_t>(summary.schemas.size());
  statistics.channel_count = static_cast<std::uint32_t>(summary.channels.size());
  statistics.attachment_count = static_cast<std::uint32_t>(summary.attachments.size());
  statistics.metadata_count = static_cast<std::uint32_t>(summary.metadata.size());
  statistics.chunk_count = static_cast<std::uint32_t>(summary.chunks.size());
}

}  // namespace

Bytes unpack(const Chunk& chunk) {
  Bytes records = decompress(chunk.compression, chunk.uncompressed_size, chunk.records);
  if (chunk.uncompressed_crc != 0 && chunk.uncompressed_crc != crc32(records)) {
    throw FormatError("the CRC of a chunk does not match its content");
  }
  return records;
}

Scan scan(const InputFile& file, std::uint64_t begin, const Progress& progress) {
  constexpr Opcode kNoOpcode{};
  Scan result;
  RecordStream stream(file, begin, file.size());
  result.readable_size = begin;
  while (!result.complete && stream.next() && stream.opcode() != kNoOpcode) {
    try {
      add_record(result.summary, stream);
    } catch (const FormatError& error) {
      result.damaged.insert(stream.offset());
      if (result.first_damage.empty()) {
        result.first_damage =
            "record at byte " + std::to_string(stream.offset()) + ": " + error.what();
      }
    }
    result.complete = stream.opcode() == Opcode::kDataEnd || stream.opcode() == Opcode::kFooter;
    result.readable_size = stream.position();
    if (progress) {
      progress(result.readable_size, file.size());
    }
  }
  count(result.summary);
  return result;
}

}  // namespace scarab::mcap
