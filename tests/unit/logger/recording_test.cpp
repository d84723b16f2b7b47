/// The writer thread, its queue, and what goes into a log at its start.
#include "services/logger/recording.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"
#include "services/logger/attachments.hpp"
#include "services/logger/config.hpp"
#include "services/logger/log_file.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::logger {
namespace {

using mcap::test::TemporaryFolder;
using namespace std::chrono_literals;

SampleBatch one_sample(std::size_t size) {
  SampleBatch batch;
  batch.add({}, mcap::Bytes(size));
  return batch;
}

TEST(BatchQueue, TellsWhenThereIsRoomAgain) {
  BatchQueue queue(1000);
  EXPECT_TRUE(queue.push(one_sample(2000)));
  EXPECT_TRUE(queue.full());
  EXPECT_FALSE(queue.wait_for_room(1ms));
  std::thread writer([&] { EXPECT_TRUE(queue.pop(10s).has_value()); });
  EXPECT_TRUE(queue.wait_for_room(10s));
  writer.join();
  EXPECT_FALSE(queue.full());
  EXPECT_EQ(queue.size_bytes(), 0U);
}

TEST(BatchQueue, BatchesWithoutSamplesPileUpToOne) {
  BatchQueue queue(1000);
  queue.push(one_sample(2000));
  for (std::uint32_t i = 0; i < 1000; ++i) {
    SampleBatch batch = one_sample(100);
    if (i == 500) batch.add_channel({"late/topic", "Late", "", TopicRole::kNone, {}});
    batch.drop_samples([](std::uint32_t) { return false; });
    queue.push(std::move(batch));
  }
  EXPECT_EQ(queue.pop(0s)->entries().size(), 1U);
  const auto rest = queue.pop(0s);
  EXPECT_EQ(rest->losses().at(0).dropped, 1000U);
  EXPECT_EQ(rest->channels().size(), 1U);
  EXPECT_FALSE(queue.pop(0s).has_value());
}

TEST(BatchQueue, ClosedTakesNothingMoreButGivesWhatItHas) {
  BatchQueue queue(1000);
  EXPECT_TRUE(queue.push(one_sample(1)));
  EXPECT_FALSE(queue.wait_for_close(0s));
  queue.close();
  EXPECT_TRUE(queue.wait_for_close(0s));
  EXPECT_FALSE(queue.push(one_sample(1)));
  EXPECT_FALSE(queue.finished());
  EXPECT_TRUE(queue.pop(0s).has_value());
  EXPECT_TRUE(queue.finished());
}

SampleBatch robot_states(std::uint32_t first, std::uint32_t last, bool with_channel) {
  SampleBatch batch;
  if (with_channel) {
    batch.add_channel(
        {"scarab/robot_state", "scarab::RobotState", "module a {};", TopicRole::kProgress, {}});
    batch.add_channel({"somebody/else", "somebody::Else", "", TopicRole::kNone, {}});
  }
  for (std::uint32_t tick = first; tick <= last; ++tick) {
    scarab_RobotState state{};
    state.header.trial = 1;
    state.header.tick = tick;
    const sample::Bytes bytes = bus::encode(state);
    SampleBatch::Entry entry;
    entry.sequence = tick;
    batch.add(entry, {bytes.data(), bytes.size()});
  }
  return batch;
}

std::unique_ptr<LogSeries> series_of(LogSeries::Open open) {
  return std::make_unique<LogSeries>(std::move(open), SeriesLimits{}, DiskSpace(nullptr, 0));
}

std::unique_ptr<LogSeries> one_file(const std::filesystem::path& path,
                                    const mcap::WriterOptions& options = {}) {
  return series_of([=](const Part&) { return std::make_unique<mcap::Writer>(path, options); });
}

TEST(Recording, WritesWhatItIsHandedAndSaysHowFarItIs) {
  TemporaryFolder folder;
  std::atomic<int> news = 0;
  Recording recording(one_file(folder / "x.mcap"), 1U << 20U, [&] { ++news; });
  recording.push(robot_states(0, 9, true));
  recording.push(robot_states(10, 19, false));
  recording.close();
  const RecordingState state = recording.state();
  EXPECT_EQ(state.progress.tick(), 19U);
  EXPECT_EQ(state.messages, 20U);
  EXPECT_EQ(state.channels, 2U);
  EXPECT_GE(news, 2);
  const mcap::Reader reader(folder / "x.mcap");
  EXPECT_EQ(reader.summary().statistics.message_count, 20U);
  const auto& unknown = reader.summary().schemas.at(reader.summary().channels.at(2).schema_id);
  EXPECT_NE(unknown.name, "");
  EXPECT_EQ(unknown.encoding + unknown.data, "") << "a type without IDL: MCAP's word for no schema";
}

TEST(Recording, AFailedWriteIsToldAndNeverBlocksThePusher) {
  TemporaryFolder folder;
  std::atomic<bool> told = false;
  Recording recording(series_of([&](const Part&) {
                        auto writer = std::make_unique<mcap::Writer>(folder / "x.mcap");
                        writer->close();  // every further write fails
                        return writer;
                      }),
                      100, [&] { told = true; });
  for (int i = 0; i < 50; ++i) recording.push(robot_states(0, 9, true));
  while (!told) std::this_thread::yield();
  EXPECT_TRUE(recording.failed());
  EXPECT_FALSE(recording.full());
  EXPECT_THROW(recording.close(), mcap::FileError);
}

TEST(Recording, ASilentTopicsChunkIsClosedByTheClock) {
  TemporaryFolder folder;
  mcap::WriterOptions options;
  options.chunk_time = 1ms;
  Recording recording(one_file(folder / "x.mcap", options), 1U << 20U, [] {});
  recording.push(robot_states(0, 3, true));
  const auto end = std::chrono::steady_clock::now() + 10s;
  while (mcap::Reader(folder / "x.mcap.active").summary().statistics.message_count < 4) {
    ASSERT_LT(std::chrono::steady_clock::now(), end) << "the chunk was never closed";
    std::this_thread::yield();
  }
}

TEST(FreeName, GoesAroundWhatAKilledRecorderHasLeft) {
  TemporaryFolder folder;
  EXPECT_EQ(free_name(folder / "x.mcap"), folder / "x.mcap");
  mcap::test::write_file(folder / "x.mcap.active", std::string_view("data"));
  EXPECT_EQ(free_name(folder / "x.mcap"), folder / "x-2.mcap");
  mcap::test::write_file(folder / "x-2.mcap", std::string_view("data"));
  EXPECT_EQ(free_name(folder / "x.mcap"), folder / "x-3.mcap");
}

TEST(Attachments, AreTheNamedFilesAndTheRunsConfiguration) {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder / "run" / "config" / "robot");
  mcap::test::write_file(folder / "run" / "config" / "robot" / "b.yaml", std::string_view("b"));
  mcap::test::write_file(folder / "run" / "config" / "a.yaml", std::string_view("a"));
  mcap::test::write_file(folder / "note.txt", std::string_view("n"));
  const auto attachments = load_attachments({folder / "note.txt"}, folder / "run");
  ASSERT_EQ(attachments.size(), 3U);
  EXPECT_EQ(attachments[0].name, "note.txt");
  EXPECT_EQ(attachments[0].media_type, "text/plain");
  EXPECT_EQ(attachments[1].name, "config/a.yaml");
  EXPECT_EQ(attachments[2].name, "config/robot/b.yaml");
  EXPECT_EQ(attachments[2].data, mcap::Bytes{'b'});
  EXPECT_THROW(load_attachments({folder / "absent"}, {}), std::runtime_error);
  EXPECT_TRUE(load_attachments({}, folder / "note.txt").empty());
}

TEST(Config, DumpsWhatItReadsBack) {
  TemporaryFolder folder;
  LoggerConfig config;
  config.chunk_size_kib = 77;
  config.compression = mcap::Compression::kNone;
  config.split = Split::kTrial;
  config.file_size_mib = 12;
  mcap::test::write_file(folder / "c.yaml", std::string_view(dump_config(config)));
  const LoggerConfig read = load_config(folder / "c.yaml");
  EXPECT_EQ(read.chunk_size_kib, 77U);
  EXPECT_EQ(read.compression, mcap::Compression::kNone);
  EXPECT_EQ(read.split, Split::kTrial);
  EXPECT_EQ(read.file_size_mib, 12U);
  EXPECT_EQ(dump_config(read), dump_config(config));
}

TEST(Config, TheShippedFileSaysTheDefaults) {
  EXPECT_EQ(dump_config(load_config(SCARAB_SOURCE_DIR "/config/logger/default.yaml")),
            dump_config(LoggerConfig{}));
}

}  // namespace
}  // namespace scarab::logger
