#pragma once

#include <map>
#include <vector>

#include "common/mcap/records.hpp"

namespace scarab::mcap {

/// What the end of a closed file says of its content, and what a scan finds out about one that was
/// never closed.
struct Summary {
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;
  std::vector<ChunkIndex> chunks;
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
};

/// Length of the footer record and the magic that end a file.
inline constexpr std::uint64_t kFileTail = kRecordPrefix + 20 + kMagic.size();

/// Everything that follows the DataEnd record, which ends at `start`: summary, summary offsets,
/// footer with the summary's CRC, magic.
Bytes encode_summary(const Summary& summary, std::uint64_t start);

/// The summary from its records. Throws FormatError.
Summary decode_summary(ByteView records);

}  // namespace scarab::mcap
