#include <gtest/gtest.h>

#include "common/mcap/decode.hpp"
#include "common/mcap/scan.hpp"
#include "tests/unit/mcap/sample_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::mcap::test {
namespace {

class Index : public testing::Test {
 protected:
  Index() {
    WriterOptions options;
    options.chunk_size_bytes = 700;
    SampleLog log(folder_ / "x.mcap", options);
    log.write(make_messages(200));
    log.writer().attach({1, 2, "a.txt", "text/plain", {'x'}});
    log.writer().close();
  }
  /// Content of the record at `offset`, checked to have `opcode`.
  Bytes record_at(std::uint64_t offset, Opcode opcode) const {
    const RecordPrefix prefix = decode_prefix(ByteView(file_).slice(offset, file_.size() - offset));
    EXPECT_EQ(prefix.opcode, opcode);
    return copy_of(ByteView(file_).slice(offset + kRecordPrefix, prefix.length));
  }

  TemporaryFolder folder_;
  Bytes file_;
  void SetUp() override { file_ = read_file(folder_ / "x.mcap"); }
};

TEST_F(Index, LeadsToEveryMessageOfEveryChunk) {
  const Reader reader(folder_ / "x.mcap");
  ASSERT_GT(reader.summary().chunks.size(), 3U);
  std::size_t found = 0;
  for (const ChunkIndex& index : reader.summary().chunks) {
    const Bytes content = record_at(index.offset, Opcode::kChunk);
    EXPECT_EQ(index.length, content.size() + kRecordPrefix);
    const Chunk chunk = decode_chunk(content);
    EXPECT_EQ(chunk.records.size(), index.compressed_size);
    const Bytes records = unpack(chunk);
    EXPECT_EQ(records.size(), index.uncompressed_size);
    std::uint64_t index_length = 0;
    for (const auto& [channel_id, offset] : index.message_index_offsets) {
      const Bytes index_content = record_at(offset, Opcode::kMessageIndex);
      index_length += index_content.size() + kRecordPrefix;
      const MessageIndex message_index = decode_message_index(index_content);
      EXPECT_EQ(message_index.channel_id, channel_id);
      for (const auto& [log_time_ns, at] : message_index.entries) {
        const ByteView rest = ByteView(records).slice(at, records.size() - at);
        const RecordPrefix prefix = decode_prefix(rest);
        EXPECT_EQ(prefix.opcode, Opcode::kMessage);
        const Message m = decode_message(rest.slice(kRecordPrefix, prefix.length));
        EXPECT_EQ(m.channel_id, channel_id);
        EXPECT_EQ(m.log_time_ns, log_time_ns);
        EXPECT_GE(m.log_time_ns, chunk.start_time_ns);
        EXPECT_LE(m.log_time_ns, chunk.end_time_ns);
        ++found;
      }
    }
    EXPECT_EQ(index_length, index.message_index_length);
  }
  EXPECT_EQ(found, 200U);
}

TEST_F(Index, SummaryOffsetsNameGroupsOfOneOpcodeThatFillTheSummary) {
  const std::size_t footer_at = file_.size() - kFileTail;
  const Footer footer = decode_footer(record_at(footer_at, Opcode::kFooter));
  std::uint64_t expected_start = footer.summary_start;
  std::set<Opcode> groups;
  RecordCursor offsets(
      ByteView(file_).slice(footer.summary_offset_start, footer_at - footer.summary_offset_start));
  while (offsets.next()) {
    ASSERT_EQ(offsets.opcode(), Opcode::kSummaryOffset);
    const SummaryOffset group = decode_summary_offset(offsets.content());
    EXPECT_EQ(group.start, expected_start);
    EXPECT_TRUE(groups.insert(group.group).second);
    RecordCursor records(ByteView(file_).slice(group.start, group.length));
    while (records.next()) {
      EXPECT_EQ(records.opcode(), group.group);
    }
    expected_start += group.length;
  }
  EXPECT_EQ(expected_start, footer.summary_offset_start);
  EXPECT_EQ(groups, (std::set<Opcode>{Opcode::kSchema, Opcode::kChannel, Opcode::kStatistics,
                                      Opcode::kChunkIndex, Opcode::kAttachmentIndex}));
}

TEST_F(Index, AChunkWithoutAWantedChannelIsNotEvenRead) {
  // Break the compressed bytes of every chunk: visiting any of them would throw.
  const Reader whole(folder_ / "x.mcap");
  for (const ChunkIndex& index : whole.summary().chunks) {
    file_[index.offset + index.length - 1] ^= 0xFFU;
  }
  write_file(folder_ / "broken.mcap", file_);
  const Reader reader(folder_ / "broken.mcap");
  EXPECT_TRUE(read_messages(reader, {"absent"}).empty());
  EXPECT_THROW(read_messages(reader, {"a"}), FormatError);
}

}  // namespace
}  // namespace scarab::mcap::test
