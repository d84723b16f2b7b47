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

TEST(BatchQueue, HoldsThePusherBackWhileItIsFull) {
  BatchQueue queue(1000);
  std::atomic<int> pushed = 0;
  std::thread pusher([&] {
    for (int i = 0; i < 10; ++i) {
      EXPECT_TRUE(queue.push(one_sample(2000)));
      ++pushed;
    }
  });
  int taken = 0;
  while (taken < 10) {
    if (queue.pop(1s)) ++taken;
    EXPECT_LE(pushed, taken + 1) << "more than one batch beyond the limit";
  }
  pusher.join();
}

TEST(BatchQueue, ClosedTakesNothingMoreButGivesWhatItHas) {
  BatchQueue queue(1000);
  EXPECT_TRUE(queue.push(one_sample(1)));
  queue.close();
  EXPECT_FALSE(queue.push(one_sample(1)));
  EXPECT_FALSE(queue.finished());
  EXPECT_TRUE(queue.pop(0s).has_value());
  EXPECT_TRUE(queue.finished());
}

SampleBatch robot_states(std::uint32_t first, std::uint32_t last, bool with_channel) {
  SampleBatch batch;
  if (with_channel) {
    batch.add_channel({"scarab/robot_state", "scarab::RobotState", "module scarab {};", true});
    batch.add_channel({"somebody/else", "somebody::Else", "", false});
  }
  for (std::uint32_t tick = first; tick <= last; ++tick) {
    scarab_RobotState state{};
    state.header.trial = 1;
    state.header.tick = tick;
    const bus::Bytes bytes = bus::encode(state);
    SampleBatch::Entry entry;
    entry.sequence = tick;
    batch.add(entry, {bytes.data(), bytes.size()});
  }
  return batch;
}

TEST(Recording, WritesWhatItIsHandedAndSaysHowFarItIs) {
  TemporaryFolder folder;
  std::atomic<int> news = 0;
  Recording recording(std::make_unique<mcap::Writer>(folder / "x.mcap"), 1U << 20U,
                      [&] { ++news; });
  recording.push(robot_states(0, 9, true));
  recording.push(robot_states(10, 19, false));
  recording.close([](const RecordingState& state) {
    EXPECT_EQ(state.progress.tick(), 19U);
    EXPECT_EQ(state.messages, 20U);
    EXPECT_EQ(state.channels, 2U);
    return mcap::Metadata{"end", {}};
  });
  EXPECT_GE(news, 2);
  const mcap::Reader reader(folder / "x.mcap");
  EXPECT_EQ(reader.summary().statistics.message_count, 20U);
  EXPECT_EQ(reader.summary().channels.at(2).schema_id, 0) << "a type without IDL has no schema";
}

TEST(Recording, AFailedWriteIsToldAndNeverBlocksThePusher) {
  TemporaryFolder folder;
  auto writer = std::make_unique<mcap::Writer>(folder / "x.mcap");
  writer->close();  // every further write fails
  std::atomic<bool> told = false;
  Recording recording(std::move(writer), 100, [&] { told = true; });
  for (int i = 0; i < 50; ++i) recording.push(robot_states(0, 9, true));
  while (!told) std::this_thread::yield();
  EXPECT_TRUE(recording.failed());
  EXPECT_THROW(recording.close([](const RecordingState&) { return mcap::Metadata{}; }),
               mcap::FileError);
}

TEST(Recording, ASilentTopicsChunkIsClosedByTheClock) {
  TemporaryFolder folder;
  mcap::WriterOptions options;
  options.chunk_time = 1ms;
  Recording recording(std::make_unique<mcap::Writer>(folder / "x.mcap", options), 1U << 20U, [] {});
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
  mcap::test::write_file(folder / "c.yaml", std::string_view(dump_config(config)));
  const LoggerConfig read = load_config(folder / "c.yaml");
  EXPECT_EQ(read.chunk_size_kib, 77U);
  EXPECT_EQ(read.compression, mcap::Compression::kNone);
  EXPECT_EQ(dump_config(read), dump_config(config));
}

}  // namespace
}  // namespace scarab::logger
