#pragma once

#include <string>
#include <vector>

#include "common/mcap/encode.hpp"
#include "common/mcap/records.hpp"

/// Bytes to records: every function takes the content of one record (without opcode and length) and
/// throws FormatError when a length leads out of it. Unknown bytes at the end are ignored, as the
/// specification asks.
namespace scarab::mcap {

Header decode_header(ByteView content);
Footer decode_footer(ByteView content);
Schema decode_schema(ByteView content);
Channel decode_channel(ByteView content);
/// `data` of the result points into `content`.
Message decode_message(ByteView content);
/// `records` of the result points into `content`.
Chunk decode_chunk(ByteView content);
ChunkIndex decode_chunk_index(ByteView content);
/// Throws FormatError also when the attachment's CRC is wrong.
Attachment decode_attachment(ByteView content);
AttachmentIndex decode_attachment_index(ByteView content);
Metadata decode_metadata(ByteView content);
MetadataIndex decode_metadata_index(ByteView content);
Statistics decode_statistics(ByteView content);
SummaryOffset decode_summary_offset(ByteView content);
std::uint32_t decode_data_end(ByteView content);

struct MessageIndex {
  std::uint16_t channel_id = 0;
  MessageOffsets entries;
};
MessageIndex decode_message_index(ByteView content);

/// Opcode and content length of the record that starts at `bytes`, of which kRecordPrefix are
/// there.
struct RecordPrefix {
  Opcode opcode = Opcode::kHeader;
  std::uint64_t length = 0;
};
RecordPrefix decode_prefix(ByteView bytes);

/// Steps through records that stand one after the other in memory.
class RecordCursor {
 public:
  explicit RecordCursor(ByteView bytes) : bytes_(bytes) {}
  /// Goes to the next record; false at the end. Throws FormatError when the next one is cut.
  bool next();
  Opcode opcode() const { return opcode_; }
  ByteView content() const { return content_; }
  /// Where the record begins, from the start of the bytes.
  std::size_t offset() const { return offset_; }

 private:
  ByteView bytes_;
  std::size_t offset_ = 0;
  std::size_t next_ = 0;
  Opcode opcode_ = Opcode::kHeader;
  ByteView content_;
};

}  // namespace scarab::mcap
