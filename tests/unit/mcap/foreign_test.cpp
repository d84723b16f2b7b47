/// Files as other writers make them: without chunks, without summary, or with one that leaves
/// things out.
#include <gtest/gtest.h>

#include "common/mcap/crc32.hpp"
#include "common/mcap/reader.hpp"
#include "common/mcap/recover.hpp"
#include "tests/unit/mcap/sample_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::mcap::test {
namespace {

class Foreign : public testing::Test {
 protected:
  /// What stands between header and summary, with the messages side by side.
  Bytes start(const std::vector<Logged>& messages) const {
    Bytes bytes(kMagic.begin(), kMagic.end());
    encode(bytes, Header{"ros2", "somebody's writer"});
    encode(bytes, Schema{7, "demo::Ab", "omgidl", "module demo { struct Ab {}; };"});
    for (std::uint16_t id = 0; id < 3; ++id) {
      encode(bytes, Channel{id,
                            id == 2 ? std::uint16_t{0} : std::uint16_t{7},
                            std::string(1, static_cast<char>('a' + id)),
                            "cdr",
                            {}});
    }
    for (const Logged& m : messages) {
      encode(bytes, Message{static_cast<std::uint16_t>(m.topic[0] - 'a'), m.sequence, m.log_time_ns,
                            m.publish_time_ns, m.data});
    }
    encode(bytes, Attachment{1, 2, "a.txt", "text/plain", {'x'}});
    encode_data_end(bytes, 0);
    return bytes;
  }
  static void finish(Bytes& bytes, const Footer& footer) {
    encode(bytes, footer);
    bytes.insert(bytes.end(), kMagic.begin(), kMagic.end());
  }
  Reader read(const Bytes& bytes) const {
    write_file(folder_ / "x.mcap", bytes);
    return Reader(folder_ / "x.mcap");
  }
  TemporaryFolder folder_;
};

TEST_F(Foreign, AFileWithoutChunksAndSummaryIsReadByAScan) {
  const auto messages = make_messages(5000);
  Bytes bytes = start(messages);
  finish(bytes, {});
  const Reader reader = read(bytes);
  EXPECT_TRUE(reader.closed());
  EXPECT_EQ(reader.damage(), "");
  EXPECT_EQ(reader.header().profile, "ros2");
  EXPECT_EQ(reader.summary().statistics.message_count, 5000U);
  EXPECT_EQ(read_messages(reader), messages);
  EXPECT_EQ(read_messages(reader, {"b"}).size(), 1667U);
  ASSERT_EQ(reader.summary().attachments.size(), 1U);
  EXPECT_EQ(reader.attachment(reader.summary().attachments[0]).data, Bytes{'x'});
}

TEST_F(Foreign, ASummaryThatLeavesSomethingOutIsNotReliedUpon) {
  const auto messages = make_messages(100);
  Bytes bytes = start(messages);
  const std::uint64_t summary_start = bytes.size();
  Statistics statistics;  // true, but neither channels nor schemas are repeated
  statistics.message_count = messages.size();
  statistics.schema_count = 1;
  statistics.channel_count = 3;
  encode(bytes, statistics);
  finish(bytes, {summary_start, 0, 0});
  const Reader reader = read(bytes);
  EXPECT_TRUE(reader.closed());
  EXPECT_EQ(reader.damage(), "");
  EXPECT_EQ(read_messages(reader), messages);
}

TEST_F(Foreign, CutInTheMiddleItIsMended) {
  const auto messages = make_messages(300);
  Bytes bytes = start(messages);
  bytes.resize(bytes.size() / 2);
  const Reader reader = read(bytes);
  EXPECT_FALSE(reader.closed());
  const auto found = read_messages(reader);
  EXPECT_GT(found.size(), 100U);
  EXPECT_EQ(found,
            std::vector<Logged>(messages.begin(),
                                messages.begin() + static_cast<std::ptrdiff_t>(found.size())));
  const Recovery recovery = recover(folder_ / "x.mcap", folder_ / "y.mcap");
  EXPECT_EQ(recovery.kept.message_count, found.size());
  const Reader mended(folder_ / "y.mcap");
  EXPECT_EQ(read_messages(mended), found);
  EXPECT_EQ(mended.header().profile, "ros2");
}

TEST_F(Foreign, ReadingEndsWhereTheVisitorSaysSo) {
  Bytes bytes = start(make_messages(50));
  finish(bytes, {});
  const Reader reader = read(bytes);
  int visited = 0;
  EXPECT_FALSE(
      reader.for_each_while([&](const Channel&, const Message&) { return ++visited < 7; }));
  EXPECT_EQ(visited, 7);
  EXPECT_TRUE(reader.for_each_while([](const Channel&, const Message&) { return true; }));
}

}  // namespace
}  // namespace scarab::mcap::test
