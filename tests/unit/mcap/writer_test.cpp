#include "common/mcap/writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/unit/mcap/sample_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::mcap::test {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

/// Lets no file of this process grow beyond a limit: a full disk that needs no disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : previous_action_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limited{bytes, previous_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &previous_);
    std::signal(SIGXFSZ, previous_action_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit previous_{};
  void (*previous_action_)(int);
};

WriterOptions small_plain_chunks() {
  WriterOptions options;
  options.compression = Compression::kNone;
  options.chunk_size_bytes = 500;
  return options;
}

TEST(Writer, IsCalledActiveUntilItIsClosed) {
  TemporaryFolder folder;
  SampleLog log(folder / "x.mcap", {});
  EXPECT_TRUE(std::filesystem::exists(folder / "x.mcap.active"));
  EXPECT_FALSE(std::filesystem::exists(folder / "x.mcap"));
  log.writer().close();
  EXPECT_FALSE(std::filesystem::exists(folder / "x.mcap.active"));
  EXPECT_TRUE(std::filesystem::exists(folder / "x.mcap"));
  EXPECT_THROW(log.write(make_messages(1)), FileError);
}

TEST(Writer, OverwritesNothingUnlessAsked) {
  TemporaryFolder folder;
  { SampleLog killed(folder / "x.mcap", {}); }
  EXPECT_THROW(Writer(folder / "x.mcap"), FileError);
  std::filesystem::rename(folder / "x.mcap.active", folder / "x.mcap");
  EXPECT_THROW(Writer(folder / "x.mcap"), FileError);
  WriterOptions overwrite;
  overwrite.overwrite = true;
  SampleLog log(folder / "x.mcap", overwrite);
  log.write(make_messages(3));
  log.writer().close();
  EXPECT_EQ(read_messages(Reader(folder / "x.mcap")).size(), 3U);
}

TEST(Writer, TakesThePlaceOfRegularFilesOnly) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "x.mcap");
  WriterOptions overwrite;
  overwrite.overwrite = true;
  EXPECT_THROW(Writer(folder / "x.mcap", overwrite), FileError);
  std::filesystem::create_symlink("/dev/null", folder / "y.mcap");
  EXPECT_THROW(Writer(folder / "y.mcap", overwrite), FileError);
  EXPECT_FALSE(std::filesystem::exists(folder / "y.mcap.active")) << "nothing was begun";
}

TEST(Writer, NamesTheFileItCannotCreate) {
  try {
    Writer writer("/nowhere/x.mcap");
    ADD_FAILURE() << "accepted";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/x.mcap.active"));
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

TEST(Writer, ClosesAChunkBySizeAndByTime) {
  TemporaryFolder folder;
  WriterOptions by_time;
  by_time.chunk_time = 100ms;
  SampleLog log(folder / "x.mcap", by_time);
  log.write(make_messages(100));  // 10 ms apart
  log.writer().close();
  const Reader timed(folder / "x.mcap");
  EXPECT_EQ(timed.summary().chunks.size(), 10U);

  SampleLog sized(folder / "y.mcap", small_plain_chunks());
  sized.write(make_messages(100));
  sized.writer().close();
  const Reader small(folder / "y.mcap");
  EXPECT_GT(small.summary().chunks.size(), 5U);
  for (const ChunkIndex& chunk : small.summary().chunks) {
    EXPECT_LT(chunk.uncompressed_size, 500U + 100U);
  }
}

TEST(Writer, AClosedChunkIsInTheFileAtOnce) {
  TemporaryFolder folder;
  SampleLog log(folder / "x.mcap", {});
  const auto messages = make_messages(10);
  log.write(messages);
  EXPECT_TRUE(read_messages(Reader(folder / "x.mcap.active")).empty());
  log.writer().close_chunk_if_due(messages[0].log_time_ns + 999'999'999U);
  EXPECT_TRUE(read_messages(Reader(folder / "x.mcap.active")).empty());
  log.writer().close_chunk_if_due(messages[0].log_time_ns + 1'000'000'000U);
  EXPECT_EQ(read_messages(Reader(folder / "x.mcap.active")), messages);
}

TEST(Writer, RefusesUnknownChannelsAndSchemas) {
  TemporaryFolder folder;
  Writer writer(folder / "x.mcap");
  EXPECT_THROW(writer.write({1, 0, 0, 0, {}}), Error);
  EXPECT_THROW(writer.add_channel(1, "t", "cdr"), Error);
}

TEST(FullDisk, IsAClearErrorAndTheClosedChunksStay) {
  TemporaryFolder folder;
  const auto messages = make_messages(400);
  {
    SampleLog log(folder / "x.mcap", small_plain_chunks());
    const FileSizeLimit limit(5000);
    try {
      log.write(messages);
      ADD_FAILURE() << "wrote beyond the limit";
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), HasSubstr("x.mcap.active"));
      EXPECT_THAT(error.what(), HasSubstr("File too large"));
    }
    EXPECT_THROW(log.writer().close(), FileError);
  }
  const Reader reader(folder / "x.mcap.active");
  EXPECT_EQ(reader.bytes_lost(), 0U) << "a half-written record was left behind";
  const auto read = read_messages(reader);
  ASSERT_GT(read.size(), 20U);
  EXPECT_TRUE(std::equal(read.begin(), read.end(), messages.begin()));
}

}  // namespace
}  // namespace scarab::mcap::test
