/// A recording as a series of files: when it goes on in the next one, and what each says.
#include "services/logger/log_series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "common/bus/cdr.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"
#include "services/logger/log_file.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::logger {
namespace {

using mcap::test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr std::uint64_t kSecond = 1'000'000'000;
constexpr std::uint64_t kMib = std::uint64_t{1} << 20U;

/// Where free space is what a test says.
struct FakeDisk {
  std::uint64_t free_bytes = 1000 * kMib;

  DiskSpace keeping(std::uint64_t keep_free_bytes) {
    return DiskSpace([this] { return std::optional<std::uint64_t>(free_bytes); }, keep_free_bytes);
  }
};

class Series : public testing::Test {
 protected:
  enum Channel : std::uint32_t { kTrials, kStates, kOther };

  LogSeries& series(const SeriesLimits& limits, std::uint64_t keep_free_bytes = 0,
                    Split split = Split::kRun) {
    const auto open = [this, split](const Part& part) {
      mcap::WriterOptions options;
      options.chunk_size_bytes = 1000;
      const auto name = free_name(part_name(folder_ / "x.mcap", split, part.trial));
      names_.push_back(name.filename().string());
      return std::make_unique<mcap::Writer>(name, options);
    };
    series_ = std::make_unique<LogSeries>(open, limits, disk_.keeping(keep_free_bytes));
    series_->add_channel({"scarab/trial", "scarab::Trial", "module a {};", TopicRole::kTrial, {}});
    series_->add_channel({"scarab/robot_state",
                          "scarab::RobotState",
                          "module a {};",
                          TopicRole::kProgress,
                          {{"word", "value"}}});
    series_->add_channel({"other", "Other", "", TopicRole::kNone, {}});
    return *series_;
  }

  void write(Channel channel, const sample::Bytes& bytes, std::uint64_t log_time_ns) {
    SampleBatch::Entry entry;
    entry.channel = channel;
    entry.sequence = count_++;
    entry.log_time_ns = log_time_ns;
    series_->write(entry, {bytes.data(), bytes.size()});
  }
  void write_state(std::uint32_t trial, std::uint32_t tick) {
    scarab_RobotState state{};
    state.header.trial = trial;
    state.header.tick = tick;
    write(kStates, bus::encode(state), tick * kSecond);
  }
  void write_trial(std::uint32_t number, const char* strategy, std::uint64_t seed) {
    scarab_Trial trial{};
    trial.header.trial = number;
    trial.header.stamp_ns = 1'700'000'000'000'000'000;
    trial.seed = seed;
    trial.goal = scarab_GOAL_TRAVEL;
    trial.goal_distance_m = 0.5;
    bus::assign(trial.strategy, strategy);
    write(kTrials, bus::encode(trial), 0);
  }

  /// The sequence numbers in all files, in the order of their coming into being.
  std::vector<std::uint32_t> recorded() const {
    std::vector<std::uint32_t> sequences;
    for (const auto& name : names_) {
      const mcap::Reader reader(folder_ / name);
      EXPECT_TRUE(reader.closed()) << name;
      reader.for_each([&](const mcap::Channel&, const mcap::Message& message) {
        sequences.push_back(message.sequence);
      });
    }
    return sequences;
  }
  /// That each message is in exactly one file, in order.
  void expect_all_recorded_once() const {
    std::vector<std::uint32_t> all(count_);
    for (std::uint32_t i = 0; i < count_; ++i) all[i] = i;
    EXPECT_EQ(recorded(), all);
  }
  std::map<std::string, std::string> metadata(const std::string& file,
                                              const std::string& name) const {
    const mcap::Reader reader(folder_ / file);
    std::map<std::string, std::string> entries;
    for (const auto& index : reader.summary().metadata) {
      if (index.name == name) entries = reader.metadata(index).entries;
    }
    return entries;
  }

  TemporaryFolder folder_;
  FakeDisk disk_;
  std::vector<std::string> names_;
  std::unique_ptr<LogSeries> series_;
  std::uint32_t count_ = 0;
};

TEST_F(Series, WithoutLimitsIsOneFile) {
  series({});
  for (std::uint32_t tick = 0; tick < 100; ++tick) write_state(1, tick);
  series_->close();
  EXPECT_THAT(names_, ElementsAre("x.mcap"));
  expect_all_recorded_once();
}

TEST_F(Series, GoesOnInTheNextFileBeyondASize) {
  SeriesLimits limits;
  limits.file_size_bytes = 20'000;
  series(limits);
  std::minstd_rand generator(5);
  for (int i = 0; i < 600; ++i) {
    sample::Bytes noise(300);
    for (auto& byte : noise) byte = static_cast<std::byte>(generator() >> 8U);
    write(kOther, noise, kSecond);
  }
  series_->close();
  ASSERT_GE(names_.size(), 8U);
  EXPECT_EQ(names_[1], "x-2.mcap");
  expect_all_recorded_once();
  for (std::size_t i = 0; i + 1 < names_.size(); ++i) {
    // The summary and one chunk more, at most.
    EXPECT_NEAR(static_cast<double>(std::filesystem::file_size(folder_ / names_[i])), 22'000, 4000);
  }
  EXPECT_EQ(series_->state().files, names_.size());
  EXPECT_EQ(series_->state().messages, 600U);
}

TEST_F(Series, GoesOnInTheNextFileAfterATime) {
  SeriesLimits limits;
  limits.file_time = 10s;
  series(limits);
  for (std::uint32_t tick = 0; tick < 35; ++tick) write_state(1, tick);  // one a second
  series_->close();
  EXPECT_THAT(names_, ElementsAre("x.mcap", "x-2.mcap", "x-3.mcap", "x-4.mcap"));
  expect_all_recorded_once();
  EXPECT_EQ(metadata("x-2.mcap", "scarab.recorded")["messages"], "10");
  EXPECT_EQ(metadata("x-4.mcap", "scarab.recorded")["messages"], "5");
}

TEST_F(Series, EachFileIsCompleteInItself) {
  SeriesLimits limits;
  limits.file_time = 10s;
  series(limits);
  write_trial(1, "soft+hard", 77);
  for (std::uint32_t tick = 0; tick < 25; ++tick) write_state(1, tick);
  series_->close();
  for (const auto& name : names_) {
    const mcap::Reader reader(folder_ / name);
    EXPECT_EQ(reader.summary().channels.size(), 3U);
    EXPECT_EQ(reader.summary().channels.at(2).metadata.at("word"), "value");
    EXPECT_EQ(reader.summary().schemas.at(1).data, "module a {};");
    EXPECT_EQ(metadata(name, "scarab.trial")["seed"], "77") << name;
  }
}

TEST_F(Series, HasAFileForEachTrialWhenAsked) {
  SeriesLimits limits;
  limits.file_per_trial = true;
  limits.file_time = 10s;
  series(limits, 0, Split::kTrial);
  write(kOther, sample::Bytes(10), 0);
  for (std::uint32_t trial : {1U, 2U, 12U}) {
    write_trial(trial, "hard", trial);
    write_trial(trial, "hard", trial);  // told again: no new trial
    for (std::uint32_t tick = 0; tick < (trial == 2 ? 15 : 5); ++tick) write_state(trial, tick);
  }
  series_->close();
  EXPECT_THAT(names_, ElementsAre("x-0000.mcap", "x-0001.mcap", "x-0002.mcap", "x-0002-2.mcap",
                                  "x-0012.mcap"));
  expect_all_recorded_once();
  EXPECT_EQ(metadata("x-0012.mcap", "scarab.trial")["number"], "12");
  EXPECT_EQ(metadata("x-0002-2.mcap", "scarab.recorded")["trials"], "1");
}

TEST_F(Series, SaysSeedAndStrategyOfEachTrial) {
  series({});
  write_trial(3, "soft+hard", 0xFFFFFFFFFFFFFFFF);
  series_->close();
  const auto trial = metadata("x.mcap", "scarab.trial");
  EXPECT_EQ(trial.at("number"), "3");
  EXPECT_EQ(trial.at("seed"), "18446744073709551615");
  EXPECT_EQ(trial.at("strategy"), "soft+hard");
  EXPECT_EQ(trial.at("goal"), "travel");
  EXPECT_EQ(trial.at("goal_distance_m"), "0.5");
  EXPECT_EQ(trial.at("announced"), "2023-11-14T22:13:20Z");
}

TEST_F(Series, SaysInEachFileWhatIsMissingThere) {
  SeriesLimits limits;
  limits.file_time = 10s;
  series(limits);
  write_state(1, 0);
  series_->note_loss(kOther, {3, 1});
  series_->note_loss(kOther, {4, 0});
  series_->note_loss(kStates, {1, 0});
  write_state(1, 4);
  write_state(1, 20);
  series_->close();
  const auto first = metadata("x.mcap", "scarab.recorded");
  EXPECT_EQ(first.at("dropped"), "8");
  EXPECT_EQ(first.at("dropped.other"), "7");
  EXPECT_EQ(first.at("dropped.scarab/robot_state"), "1");
  EXPECT_EQ(first.at("lost"), "1");
  EXPECT_EQ(first.at("missed_ticks"), "3");
  EXPECT_EQ(metadata("x-2.mcap", "scarab.recorded").at("dropped"), "0");
  EXPECT_EQ(metadata("x-2.mcap", "scarab.recorded").at("missed_ticks"), "15");
}

/// The disk is asked again at most every 10 ms.
bool comes_to(LogSeries& series, bool room, std::uint64_t pending_bytes = 0,
              std::chrono::milliseconds limit = 10s) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < end) {
    if (series.has_room(pending_bytes) == room) return true;
  }
  return false;
}

TEST_F(Series, OnAFullDiskIsClosedWholeAndGoesOnInANewFile) {
  series({}, 100 * kMib);
  write_state(1, 0);
  EXPECT_TRUE(series_->has_room(0));
  disk_.free_bytes = 99 * kMib;
  ASSERT_TRUE(comes_to(*series_, false));
  EXPECT_THAT(series_->obstacle(), HasSubstr("99 MiB are free, free_disk_mib is 100"));
  EXPECT_TRUE(mcap::Reader(folder_ / "x.mcap").closed());
  disk_.free_bytes = 105 * kMib;  // not enough to begin again
  EXPECT_FALSE(comes_to(*series_, true, 0, 50ms));
  disk_.free_bytes = 200 * kMib;
  ASSERT_TRUE(comes_to(*series_, true));
  EXPECT_EQ(series_->obstacle(), "");
  write_state(1, 1);
  series_->close();
  EXPECT_THAT(names_, ElementsAre("x.mcap", "x-2.mcap"));
  expect_all_recorded_once();
}

TEST_F(Series, MindsWhatWaitsToBeWritten) {
  series({}, 100 * kMib);
  disk_.free_bytes = 150 * kMib;
  EXPECT_TRUE(comes_to(*series_, true, 49 * kMib));
  EXPECT_TRUE(comes_to(*series_, false, 51 * kMib));
}

TEST_F(Series, BeginsWithNoFileOnAFullDisk) {
  disk_.free_bytes = 0;
  series({}, 100 * kMib);
  EXPECT_FALSE(series_->has_room(0));
  EXPECT_TRUE(names_.empty());
  disk_.free_bytes = 1000 * kMib;
  ASSERT_TRUE(comes_to(*series_, true));
  write_state(1, 0);
  series_->close();
  expect_all_recorded_once();
}

}  // namespace
}  // namespace scarab::logger
