#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "common/mcap/recover.hpp"
#include "tests/unit/mcap/sample_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::mcap::test {
namespace {

using testing::HasSubstr;

class Damage : public testing::TestWithParam<Compression> {
 protected:
  static constexpr std::size_t kMessages = 40;
  Damage() {
    WriterOptions options;
    options.compression = GetParam();
    options.chunk_size_bytes = 200;
    SampleLog log(folder_ / "whole.mcap", options);
    log.writer().attach({1, 2, "a.txt", "text/plain", {'h', 'e', 'l', 'l', 'o'}});
    log.write(messages_);
    log.writer().close();
    file_ = read_file(folder_ / "whole.mcap");
  }

  TemporaryFolder folder_;
  std::vector<Logged> messages_ = make_messages(kMessages);
  Bytes file_;
};

TEST_P(Damage, CutAtAnyByteYieldsEveryCompleteChunkAndNothingElse) {
  const Reader whole(folder_ / "whole.mcap");
  const auto path = folder_ / "cut.mcap";
  // Messages that lie in chunks which end at or before a cut.
  std::vector<std::pair<std::uint64_t, std::size_t>> readable_from;
  std::size_t so_far = 0;
  for (const ChunkIndex& chunk : whole.summary().chunks) {
    for (const Logged& m : messages_) {
      so_far += m.log_time_ns >= chunk.start_time_ns && m.log_time_ns <= chunk.end_time_ns ? 1 : 0;
    }
    readable_from.emplace_back(chunk.offset + chunk.length, so_far);
  }
  ASSERT_EQ(so_far, kMessages);
  const std::size_t header_end = kMagic.size() + kRecordPrefix + 4 + 4 + 6;
  write_file(path, file_);
  for (std::size_t cut = file_.size(); cut-- > 0;) {
    std::filesystem::resize_file(path, cut);
    if (cut < header_end) {
      EXPECT_THROW(Reader{path}, FormatError) << "cut at " << cut;
      continue;
    }
    std::size_t expected = 0;
    for (const auto& [end, count] : readable_from) {
      expected = end <= cut ? count : expected;
    }
    const Reader reader(path);
    EXPECT_FALSE(reader.closed()) << "cut at " << cut;
    const auto read = read_messages(reader);
    ASSERT_EQ(read.size(), expected) << "cut at " << cut;
    EXPECT_TRUE(std::equal(read.begin(), read.end(), messages_.begin())) << "cut at " << cut;
    EXPECT_EQ(reader.summary().statistics.message_count, expected);
  }
}

TEST_P(Damage, AFlippedBitInAChunkNeverChangesAMessageUnnoticed) {
  const Reader whole(folder_ / "whole.mcap");
  const ChunkIndex& chunk = whole.summary().chunks.at(1);
  const auto path = folder_ / "flipped.mcap";
  const std::uint64_t records_at = chunk.offset + chunk.length - chunk.compressed_size;
  std::size_t noticed = 0;
  for (std::uint64_t at = records_at; at < chunk.offset + chunk.length; ++at) {
    Bytes flipped = file_;
    flipped[at] ^= 0x10U;
    write_file(path, flipped);
    const Reader reader(path);
    try {
      EXPECT_EQ(read_messages(reader), messages_) << "byte " << at << " flipped, nobody noticed";
    } catch (const FormatError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
      EXPECT_THAT(error.what(), HasSubstr("record at byte " + std::to_string(chunk.offset)));
      ++noticed;
    }
  }
  // A compressed frame has bits without a meaning; plain records have none.
  EXPECT_GE(noticed, GetParam() == Compression::kNone ? chunk.compressed_size
                                                      : chunk.compressed_size * 9 / 10);
}

TEST_P(Damage, RecoverLeavesOutADamagedChunkAndKeepsTheRest) {
  const Reader whole(folder_ / "whole.mcap");
  const ChunkIndex& chunk = whole.summary().chunks.at(2);
  Bytes flipped = file_;
  flipped[chunk.offset + chunk.length - 1] ^= 0x01U;
  write_file(folder_ / "flipped.mcap", flipped);
  const Recovery recovery = recover(folder_ / "flipped.mcap", folder_ / "mended.mcap");
  EXPECT_THAT(recovery.damage, HasSubstr("record at byte " + std::to_string(chunk.offset)));
  std::vector<Logged> rest;
  std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(rest), [&](const Logged& m) {
    return m.log_time_ns < chunk.start_time_ns || m.log_time_ns > chunk.end_time_ns;
  });
  EXPECT_LT(rest.size(), messages_.size());
  EXPECT_EQ(read_messages(Reader(folder_ / "mended.mcap")), rest);
}

TEST_P(Damage, AFlippedByteInTheSummaryFallsBackToAScan) {
  Bytes flipped = file_;
  flipped[flipped.size() - kFileTail - 3] ^= 0x01U;
  write_file(folder_ / "flipped.mcap", flipped);
  const Reader reader(folder_ / "flipped.mcap");
  EXPECT_THAT(reader.damage(), HasSubstr("CRC of the summary"));
  EXPECT_EQ(read_messages(reader), messages_);
}

TEST_P(Damage, AFlippedByteInAnAttachmentIsNoticed) {
  const AttachmentIndex index = Reader(folder_ / "whole.mcap").summary().attachments.at(0);
  Bytes flipped = file_;
  flipped[index.offset + index.length - 5] ^= 0x01U;  // its last data byte
  write_file(folder_ / "flipped.mcap", flipped);
  const Reader reader(folder_ / "flipped.mcap");
  EXPECT_THROW(reader.attachment(index), FormatError);
  EXPECT_TRUE(Reader(folder_ / "flipped.mcap", Access::kScan).summary().attachments.empty());
}

TEST_P(Damage, RandomDamageNeverCrashesAReaderNorInventsMessages) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> where(0, file_.size() - 1);
  std::uniform_int_distribution<int> what(0, 255);
  const auto path = folder_ / "random.mcap";
  for (int round = 0; round < 400; ++round) {
    Bytes damaged = file_;
    for (int flips = 0; flips < 3; ++flips) {
      damaged[where(random)] = static_cast<std::uint8_t>(what(random));
    }
    write_file(path, damaged);
    try {
      for (const Logged& m : read_messages(Reader(path, Access::kScan))) {
        EXPECT_NE(std::find(messages_.begin(), messages_.end(), m), messages_.end());
      }
    } catch (const Error&) {  // the one other answer that is allowed
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Compressions, Damage,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd),
                         [](const auto& layout) {
                           return layout.param == Compression::kNone ? "plain"
                                                                     : name_of(layout.param);
                         });

TEST(Recover, MakesAClosedFileOfAnActiveOne) {
  TemporaryFolder folder;
  const auto messages = make_messages(100);
  WriterOptions options;
  options.chunk_size_bytes = 500;
  {
    SampleLog log(folder / "x.mcap", options);
    log.writer().attach({1, 2, "a.txt", "text/plain", {'h', 'i'}});
    log.writer().add_metadata({"scarab", {{"version", "1"}}});
    log.write(messages);
    log.writer().close_chunk();
    log.write(make_messages(2));  // stays in the open chunk and is lost
  }
  const Recovery recovery = recover(folder / "x.mcap.active", folder / "y.mcap");
  EXPECT_EQ(recovery.kept.message_count, messages.size());
  EXPECT_EQ(recovery.bytes_lost, 0U);
  const Reader reader(folder / "y.mcap");
  EXPECT_TRUE(reader.closed());
  EXPECT_EQ(read_messages(reader), messages);
  EXPECT_EQ(reader.attachment(reader.summary().attachments.at(0)).data, (Bytes{'h', 'i'}));
  EXPECT_EQ(reader.summary().metadata.at(0).name, "scarab");
  EXPECT_EQ(reader.summary().metadata.at(1).name, "scarab.recovered");
}

/// A log of the project's recorder that numbers what it has taken of a topic, and of topic b has
/// dropped four in two places.
void write_log_with_gaps(const std::filesystem::path& path, const std::string& recorder) {
  SampleLog log(path, {});
  log.writer().add_metadata({recorder, {}});
  std::vector<Logged> messages = make_messages(30);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i / 3) + 5;
    const bool is_b = messages[i].topic == "b";
    messages[i].sequence = is_b && number > 7 ? number + (number > 10 ? 4 : 1) : number;
  }
  std::swap(messages[3].sequence, messages[6].sequence);  // not in the order of time
  log.write(messages);
  log.writer().close_chunk();
}

TEST(Recover, CountsTheGapsInTheNumbersOfARecording) {
  TemporaryFolder folder;
  write_log_with_gaps(folder / "x.mcap", "scarab.recording");
  const Recovery recovery = recover(folder / "x.mcap.active", folder / "y.mcap");
  EXPECT_EQ(recovery.missing, (std::map<std::string, std::uint64_t>{{"b", 4}}));
  const Reader reader(folder / "y.mcap");
  const Metadata said = reader.metadata(reader.summary().metadata.at(1));
  EXPECT_EQ(said.entries.at("missing"), "4");
  EXPECT_EQ(said.entries.at("missing.b"), "4");
  EXPECT_EQ(said.entries.count("missing.a"), 0U);
}

TEST(Recover, MakesNothingOfTheNumbersOfOthers) {
  TemporaryFolder folder;
  write_log_with_gaps(folder / "x.mcap", "somebody's recording");
  EXPECT_TRUE(recover(folder / "x.mcap.active", folder / "y.mcap").missing.empty());
}

TEST(NotAnMcapFile, IsSaidSo) {
  TemporaryFolder folder;
  write_file(folder / "text", std::string_view("hello, this is no MCAP file at all"));
  try {
    Reader reader(folder / "text");
    ADD_FAILURE() << "accepted";
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), HasSubstr("not an MCAP file"));
  }
  EXPECT_THROW(Reader(folder / "absent"), FileError);
}

}  // namespace
}  // namespace scarab::mcap::test
