#include <gtest/gtest.h>

#include "tests/unit/mcap/sample_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::mcap::test {
namespace {

struct Layout {
  const char* name;
  Compression compression;
  std::size_t chunk_size_bytes;
};

void PrintTo(const Layout& layout, std::ostream* out) { *out << layout.name; }

class RoundTrip : public testing::TestWithParam<Layout> {
 protected:
  WriterOptions options() const {
    WriterOptions options;
    options.compression = GetParam().compression;
    options.chunk_size_bytes = GetParam().chunk_size_bytes;
    return options;
  }
  TemporaryFolder folder_;
};

TEST_P(RoundTrip, GivesBackEveryMessageInOrder) {
  const auto messages = make_messages(500);
  SampleLog log(folder_ / "x.mcap", options());
  log.write(messages);
  log.writer().close();
  const Reader indexed(folder_ / "x.mcap");
  EXPECT_TRUE(indexed.closed());
  EXPECT_EQ(indexed.damage(), "");
  EXPECT_EQ(read_messages(indexed), messages);
  const Reader scanned(folder_ / "x.mcap", Access::kScan);
  EXPECT_TRUE(scanned.closed());
  EXPECT_EQ(scanned.damage(), "");
  EXPECT_EQ(scanned.bytes_lost(), 0U);
  EXPECT_EQ(read_messages(scanned), messages);
}

TEST_P(RoundTrip, KeepsSchemasChannelsAttachmentsAndMetadata) {
  SampleLog log(folder_ / "x.mcap", options());
  const Attachment config{7, 5, "plant.yaml", "application/yaml", {'a', ':', ' ', '1'}};
  log.writer().attach(config);
  log.write(make_messages(10));
  log.writer().add_metadata({"scarab", {{"version", "0.1.0"}, {"empty", ""}}});
  log.writer().close();

  const Reader reader(folder_ / "x.mcap");
  const Summary& summary = reader.summary();
  ASSERT_EQ(summary.schemas.size(), 1U);
  EXPECT_EQ(summary.schemas.at(1).name, "demo::Ab");
  EXPECT_EQ(summary.schemas.at(1).encoding, "omgidl");
  ASSERT_EQ(summary.channels.size(), 3U);
  EXPECT_EQ(summary.channels.at(1).metadata.at("kind"), "first");
  EXPECT_EQ(summary.channels.at(3).schema_id, 0);
  ASSERT_EQ(summary.attachments.size(), 1U);
  EXPECT_EQ(reader.attachment(summary.attachments[0]).data, config.data);
  EXPECT_EQ(reader.attachment(summary.attachments[0]).name, config.name);
  ASSERT_EQ(summary.metadata.size(), 1U);
  EXPECT_EQ(reader.metadata(summary.metadata[0]).entries,
            (std::map<std::string, std::string>{{"version", "0.1.0"}, {"empty", ""}}));
}

TEST_P(RoundTrip, FiltersByTopic) {
  const auto messages = make_messages(100);
  SampleLog log(folder_ / "x.mcap", options());
  log.write(messages);
  log.writer().close();
  std::vector<Logged> wanted;
  std::copy_if(messages.begin(), messages.end(), std::back_inserter(wanted),
               [](const Logged& m) { return m.topic == "b"; });
  EXPECT_EQ(read_messages(Reader(folder_ / "x.mcap"), {"b"}), wanted);
  EXPECT_TRUE(read_messages(Reader(folder_ / "x.mcap"), {"nobody"}).empty());
}

INSTANTIATE_TEST_SUITE_P(Layouts, RoundTrip,
                         testing::Values(Layout{"oneZstdChunk", Compression::kZstd, 1U << 20U},
                                         Layout{"manyZstdChunks", Compression::kZstd, 300},
                                         Layout{"oneLz4Chunk", Compression::kLz4, 1U << 20U},
                                         Layout{"manyLz4Chunks", Compression::kLz4, 300},
                                         Layout{"manyPlainChunks", Compression::kNone, 300}),
                         [](const auto& layout) { return layout.param.name; });

TEST(Statistics, CountMessagesPerChannelAndTheTimeSpan) {
  TemporaryFolder folder;
  const auto messages = make_messages(301);
  SampleLog log(folder / "x.mcap", {});
  log.write(messages);
  log.writer().close();
  const Reader reader(folder / "x.mcap");
  const Statistics& statistics = reader.summary().statistics;
  EXPECT_EQ(statistics.message_count, 301U);
  EXPECT_EQ(statistics.channel_message_counts.at(1), 101U);
  EXPECT_EQ(statistics.channel_message_counts.at(3), 100U);
  EXPECT_EQ(statistics.start_time_ns, messages.front().log_time_ns);
  EXPECT_EQ(statistics.end_time_ns, messages.back().log_time_ns);
  EXPECT_EQ(statistics.chunk_count, reader.summary().chunks.size());
}

TEST(EmptyLog, IsAValidFileWithItsChannels) {
  TemporaryFolder folder;
  SampleLog log(folder / "x.mcap", {});
  log.writer().close();
  const Reader reader(folder / "x.mcap");
  EXPECT_TRUE(reader.closed());
  EXPECT_EQ(reader.summary().channels.size(), 3U);
  EXPECT_EQ(reader.summary().statistics.message_count, 0U);
  EXPECT_EQ(Reader(folder / "x.mcap", Access::kScan).summary().channels.size(), 3U);
}

}  // namespace
}  // namespace scarab::mcap::test
