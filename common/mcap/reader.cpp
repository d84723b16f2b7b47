#include "common/mcap/reader.hpp"

#include <algorithm>

#include "common/mcap/crc32.hpp"
#include "common/mcap/decode.hpp"
#include "common/mcap/record_stream.hpp"
#include "common/mcap/scan.hpp"

namespace scarab::mcap {
namespace {

bool starts_with_magic(ByteView bytes) {
  return std::equal(bytes.begin(), bytes.end(), kMagic.begin(), kMagic.end());
}

/// What a summary repeats of the data section is its writer's choice; only one that leaves nothing
/// out saves the scan.
bool is_whole(const Summary& summary) {
  const Statistics& counted = summary.statistics;
  return counted.channel_count > 0 && counted.schema_count == summary.schemas.size() &&
         counted.channel_count == summary.channels.size() &&
         counted.chunk_count == summary.chunks.size() &&
         counted.attachment_count == summary.attachments.size() &&
         counted.metadata_count == summary.metadata.size();
}

}  // namespace

Reader::Reader(const std::filesystem::path& path, Access access, const Progress& progress)
    : file_(path) {
  if (file_.size() < kMagic.size() || !starts_with_magic(file_.read(0, kMagic.size()))) {
    throw FormatError(path.string() + ": not an MCAP file");
  }
  RecordStream first(file_, kMagic.size(), file_.size());
  if (!first.next() || first.opcode() != Opcode::kHeader) {
    throw FormatError(path.string() + ": an MCAP file without its header: nothing to read");
  }
  header_ = decode_header(first.content());
  data_begin_ = first.position();
  data_end_ = file_.size();
  if (access == Access::kScan || !read_summary()) {
    read_by_scan(progress);
  }
}

/// False when there is none to rely on.
bool Reader::read_summary() {
  if (file_.size() < data_begin_ + kFileTail) {
    return false;
  }
  const std::uint64_t footer_at = file_.size() - kFileTail;
  const Bytes tail = file_.read(footer_at, kFileTail);
  const ByteView end = ByteView(tail).slice(tail.size() - kMagic.size(), kMagic.size());
  const RecordPrefix prefix = decode_prefix(tail);
  if (!starts_with_magic(end) || prefix.opcode != Opcode::kFooter) {
    return false;
  }
  const Footer footer = decode_footer(
      ByteView(tail).slice(kRecordPrefix, tail.size() - kRecordPrefix - kMagic.size()));
  if (footer.summary_start < data_begin_ || footer.summary_start >= footer_at) {
    return false;
  }
  try {
    const Bytes summary = file_.read(footer.summary_start, footer_at - footer.summary_start);
    Crc32 crc;
    crc.update(summary);
    crc.update(footer_before_crc(footer));
    if (footer.summary_crc != 0 && footer.summary_crc != crc.value()) {
      throw FormatError("the CRC of the summary does not match its content");
    }
    summary_ = decode_summary(summary);
    if (!is_whole(summary_)) {
      return false;
    }
  } catch (const FormatError& error) {
    damage_ = error.what();
    return false;
  }
  data_end_ = footer.summary_start;
  closed_ = true;
  return true;
}

void Reader::read_by_scan(const Progress& progress) {
  Scan found = scan(file_, data_begin_, progress);
  summary_ = std::move(found.summary);
  damaged_ = std::move(found.damaged);
  closed_ = found.complete && file_.size() >= kMagic.size() &&
            starts_with_magic(file_.read(file_.size() - kMagic.size(), kMagic.size()));
  data_end_ = found.readable_size;
  bytes_lost_ = closed_ ? 0 : file_.size() - found.readable_size;
  if (damage_.empty()) {
    damage_ = std::move(found.first_damage);
  }
}

/// An index that lists the channels of a chunk saves reading it.
bool Reader::wanted(std::uint64_t chunk_offset, const std::set<std::uint16_t>& channels) const {
  const auto index =
      std::lower_bound(summary_.chunks.begin(), summary_.chunks.end(), chunk_offset,
                       [](const ChunkIndex& chunk, std::uint64_t at) { return chunk.offset < at; });
  if (index == summary_.chunks.end() || index->offset != chunk_offset ||
      index->message_index_offsets.empty()) {
    return true;
  }
  return std::any_of(index->message_index_offsets.begin(), index->message_index_offsets.end(),
                     [&](const auto& entry) { return channels.count(entry.first) != 0; });
}

bool Reader::visit_chunk(ByteView content, const std::set<std::uint16_t>& channels,
                         const Judge& visit) const {
  const Bytes records = unpack(decode_chunk(content));
  RecordCursor cursor(records);
  while (cursor.next()) {
    if (cursor.opcode() == Opcode::kMessage) {
      const Message message = decode_message(cursor.content());
      if (channels.count(message.channel_id) != 0 &&
          !visit(summary_.channels.at(message.channel_id), message)) {
        return false;
      }
    }
  }
  return true;
}

bool Reader::visit_record(RecordStream& stream, const std::set<std::uint16_t>& channels,
                          const Judge& visit) const {
  if (stream.opcode() == Opcode::kChunk && wanted(stream.offset(), channels)) {
    return visit_chunk(stream.content(), channels, visit);
  }
  if (stream.opcode() == Opcode::kMessage) {
    const Message message = decode_message(stream.content());
    return channels.count(message.channel_id) == 0 ||
           visit(summary_.channels.at(message.channel_id), message);
  }
  return true;
}

bool Reader::for_each_while(const Judge& visit, const std::set<std::string>& topics) const {
  std::set<std::uint16_t> channels;
  for (const auto& [id, channel] : summary_.channels) {
    if (topics.empty() || topics.count(channel.topic) != 0) {
      channels.insert(id);
    }
  }
  RecordStream stream(file_, data_begin_, data_end_);
  while (stream.next() && stream.opcode() != Opcode::kDataEnd) {
    try {
      if (damaged_.count(stream.offset()) == 0 && !visit_record(stream, channels, visit)) {
        return false;
      }
    } catch (const FormatError& error) {
      throw FormatError(path().string() + ": record at byte " + std::to_string(stream.offset()) +
                        ": " + error.what());
    }
  }
  return true;
}

void Reader::for_each(const Visitor& visit, const std::set<std::string>& topics) const {
  for_each_while(
      [&](const Channel& channel, const Message& message) {
        visit(channel, message);
        return true;
      },
      topics);
}

Bytes Reader::record(std::uint64_t offset, std::uint64_t length) const {
  if (length < kRecordPrefix) {
    throw FormatError(path().string() + ": an index entry is too short for a record");
  }
  return file_.read(offset + kRecordPrefix, length - kRecordPrefix);
}

Attachment Reader::attachment(const AttachmentIndex& index) const {
  return decode_attachment(record(index.offset, index.length));
}

Metadata Reader::metadata(const MetadataIndex& index) const {
  return decode_metadata(record(index.offset, index.length));
}

}  // namespace scarab::mcap
