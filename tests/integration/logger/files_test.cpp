/// The recorder as a process: its files, one after the other, and what it does when it cannot keep
/// up with what comes or finds no room.
#include <set>

#include "common/bus/raw_writer.hpp"
#include "common/bus/sample_fields.hpp"
#include "tests/integration/logger/fixture.hpp"
#include "tests/integration/logger/reading.hpp"
#include "tests/support/ballast.hpp"

namespace scarab::logger::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Files : public LoggerTest {
 protected:
  std::unique_ptr<scarab::test::ChildProcess> start_with(const std::string& config) {
    mcap::test::write_file(folder_ / "logger.yaml", std::string_view(config));
    return start({"--output", (folder_ / "x.mcap").string(), "--config",
                  (folder_ / "logger.yaml").string()});
  }

  /// All logs, in the order of their first message.
  std::vector<std::filesystem::path> logs() const {
    std::map<std::uint64_t, std::filesystem::path> ordered;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / ".")) {
      EXPECT_NE(entry.path().extension(), ".active") << "was not closed";
      if (entry.path().extension() != ".mcap") continue;
      ordered[mcap::Reader(entry.path()).summary().statistics.start_time_ns] = entry.path();
    }
    std::vector<std::filesystem::path> paths;
    for (const auto& [time, path] : ordered) paths.push_back(path.lexically_normal());
    return paths;
  }

  /// The samples of a topic over all logs.
  std::vector<mcap::Bytes> samples_of(const std::string& topic) const {
    std::vector<mcap::Bytes> all;
    for (const auto& path : logs()) {
      const auto part = read_samples(path)[topic];
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  bool write_states(bus::Writer<scarab_RobotState>& writer, std::uint32_t trial,
                    std::uint32_t first, std::uint32_t last, bool real_time = false) {
    for (std::uint32_t tick = first; tick <= last; ++tick) {
      if (!eventually([&] { return may_write(trial, tick); })) return false;
      scarab_RobotState state = robot_state(trial, tick);
      state.real_time = real_time;
      write(writer, state);
    }
    return eventually(
        [&] { return status().recorded_trial == trial && status().recorded_tick == last; });
  }

  /// Readings that a recorder gets all, however late it is and however long it takes.
  std::unique_ptr<bus::RawWriter> readings() {
    bus::RawQos qos;
    qos.durability = DDS_DURABILITY_TRANSIENT_LOCAL;
    qos.history_depth = 0;
    return std::make_unique<bus::RawWriter>(participant_, "meadow/reading",
                                            bus::borrow_compiled(bus::descriptor<meadow_Reading>()),
                                            qos);
  }
};

TEST_F(Files, EachTrialHasItsOwnWithItsSeedAndStrategy) {
  auto logger = start_with("split: trial\n");
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  ASSERT_TRUE(wait_for_reader(states)) << logger->output();
  for (const std::uint32_t trial : {1U, 2U, 3U}) {
    scarab_Trial announced{};
    announced.header.trial = trial;
    announced.seed = 100 + trial;
    bus::assign(announced.strategy, "soft+hard");
    trials_.write(announced);
    ASSERT_TRUE(eventually([&] { return status().ready_trial == trial; })) << status().message;
    ASSERT_TRUE(write_states(states, trial, 0, 9)) << logger->output();
  }
  logger->signal(SIGTERM);
  ASSERT_EQ(logger->wait(20s), 0) << logger->output();

  EXPECT_THAT(logs(), ElementsAre(folder_ / "x-0000.mcap", folder_ / "x-0001.mcap",
                                  folder_ / "x-0002.mcap", folder_ / "x-0003.mcap"));
  EXPECT_TRUE(samples_of("scarab/robot_state") == sent_.at("scarab/robot_state"));
  for (const std::uint32_t trial : {1U, 2U, 3U}) {
    const mcap::Reader reader(folder_ / ("x-000" + std::to_string(trial) + ".mcap"));
    auto metadata = read_metadata(reader);
    EXPECT_EQ(metadata["scarab.trial"]["seed"], std::to_string(100 + trial));
    EXPECT_EQ(metadata["scarab.trial"]["strategy"], "soft+hard");
    EXPECT_EQ(metadata["scarab.recording"]["part"], std::to_string(trial + 1));
    EXPECT_EQ(read_samples(reader.path())["scarab/trial"].size(), 1U);
  }
}

TEST_F(Files, ARunGoesOnInTheNextBeyondItsSize) {
  constexpr std::uint32_t kReadings = 10'000;
  auto logger = start_with("file_size_mib: 1\nchunk_size_kib: 64\ncompression: none\n");
  auto writer = readings();
  for (std::uint32_t i = 0; i < kReadings; ++i) writer->write(encode_reading(i));
  ASSERT_TRUE(eventually([&] { return counter("messages") > kReadings; })) << logger->output();
  logger->signal(SIGTERM);
  ASSERT_EQ(logger->wait(20s), 0) << logger->output();
  EXPECT_THAT(logs(), ElementsAre(folder_ / "x.mcap", folder_ / "x-2.mcap", folder_ / "x-3.mcap"));
  std::uint32_t next = 0;
  for (const mcap::Bytes& bytes : samples_of("meadow/reading")) {
    ASSERT_EQ(decode_reading(bytes).number, next);
    ++next;
  }
  EXPECT_EQ(next, kReadings);
}

/// A recorder that cannot compress as fast as samples come, with little room for those that wait.
class Slow : public Files {
 protected:
  static constexpr std::uint32_t kReadings = 20'000;

  /// A flood in a trial that runs in lockstep or in real time; then the log's end.
  void flood(bool real_time) {
    auto logger = start_with("compression_level: 19\nqueue_mib: 1\n");
    bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
    ASSERT_TRUE(wait_for_reader(states)) << logger->output();
    ASSERT_TRUE(wait_until_ready(1)) << logger->output();
    ASSERT_TRUE(write_states(states, 1, 0, 3, real_time)) << logger->output();
    auto writer = readings();
    for (std::uint32_t i = 0; i < kReadings; ++i) writer->write(encode_reading(i));
    ASSERT_TRUE(
        eventually([&] { return counter("messages") + counter("dropped") > kReadings; }, 60s))
        << counter("messages") << " recorded, " << counter("dropped") << " dropped";
    said_ = status().message;
    health_ = status().health;
    logger->signal(SIGTERM);
    ASSERT_EQ(logger->wait(60s), 0) << logger->output();
    recorded_ = samples_of("meadow/reading");
    metadata_ = read_metadata(mcap::Reader(folder_ / "x.mcap"))["scarab.recorded"];
  }

  std::string said_;
  scarab_Health health_{};
  std::vector<mcap::Bytes> recorded_;
  std::map<std::string, std::string> metadata_;
};

TEST_F(Slow, InRealTimeCountsExactlyWhatItDrops) {
  ASSERT_NO_FATAL_FAILURE(flood(true));
  const std::uint64_t dropped = std::stoull(metadata_.at("dropped.meadow/reading"));
  EXPECT_GT(dropped, 0U);
  EXPECT_EQ(recorded_.size() + dropped, kReadings);
  std::set<std::uint32_t> numbers;
  for (const mcap::Bytes& bytes : recorded_) numbers.insert(decode_reading(bytes).number);
  EXPECT_EQ(numbers.size(), recorded_.size());
  EXPECT_EQ(health_, scarab_HEALTH_DEGRADED);
  EXPECT_THAT(said_, HasSubstr("samples dropped (meadow/reading "));
}

TEST_F(Slow, InLockstepDropsNothing) {
  ASSERT_NO_FATAL_FAILURE(flood(false));
  EXPECT_EQ(metadata_.at("dropped"), "0");
  EXPECT_EQ(recorded_.size(), kReadings);
  EXPECT_EQ(health_, scarab_HEALTH_OK) << said_;
}

TEST_F(Files, OnAFullDiskTheLogIsClosedWholeAndGoesOnWhenThereIsRoom) {
  constexpr std::uint64_t kMib = std::uint64_t{1} << 20U;
  constexpr std::uint64_t kMargin =
      256;  // MiB by which others may fill or empty the disk meanwhile
  const std::uint64_t free_mib = std::filesystem::space(folder_ / ".").available / kMib;
  ASSERT_GT(free_mib, 3 * kMargin) << "the test needs room on the disk of " << folder_ / ".";
  auto logger =
      start_with("queue_mib: 1\nfree_disk_mib: " + std::to_string(free_mib - kMargin) + "\n");
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  ASSERT_TRUE(wait_for_reader(states)) << logger->output();
  ASSERT_TRUE(wait_until_ready(1)) << logger->output();
  ASSERT_TRUE(write_states(states, 1, 0, 19)) << logger->output();
  {
    const scarab::test::Ballast ballast(folder_ / "ballast", 2 * kMargin * kMib);
    ASSERT_TRUE(eventually([&] { return status().health == scarab_HEALTH_FAULT; }))
        << status().message;
    EXPECT_THAT(status().message, HasSubstr("disk too full to record: "));
    EXPECT_TRUE(mcap::Reader(folder_ / "x.mcap").closed());
    for (std::uint32_t tick = 20; tick < 40; ++tick) write(states, robot_state(1, tick));
    EXPECT_FALSE(eventually([&] { return status().recorded_tick >= 20; }, 300ms));
    // Nobody is told that a trial may begin of which nothing could be recorded.
    scarab_Trial trial{};
    trial.header.trial = 2;
    trials_.write(trial);
    EXPECT_FALSE(eventually([&] { return status().ready_trial == 2; }, 300ms));
  }
  ASSERT_TRUE(eventually([&] { return status().recorded_tick == 39; })) << status().message;
  ASSERT_TRUE(eventually([&] { return status().ready_trial == 2; })) << status().message;
  EXPECT_EQ(status().health, scarab_HEALTH_OK);
  logger->signal(SIGTERM);
  ASSERT_EQ(logger->wait(20s), 0) << logger->output();
  EXPECT_THAT(logs(), ElementsAre(folder_ / "x.mcap", folder_ / "x-2.mcap"));
  EXPECT_TRUE(samples_of("scarab/robot_state") == sent_.at("scarab/robot_state"));
}

TEST_F(Files, StoppedOnAFullDiskItSaysWhatIsMissing) {
  auto logger = start_with("free_disk_mib: 1000000000\n");
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  ASSERT_TRUE(wait_for_reader(states)) << logger->output();
  ASSERT_TRUE(eventually([&] { return status().health == scarab_HEALTH_FAULT; }));
  write(states, robot_state(1, 0));
  logger->signal(SIGTERM);
  EXPECT_EQ(logger->wait(20s), 1);
  EXPECT_THAT(logger->output(), HasSubstr("free_disk_mib is 1000000000"));
  EXPECT_TRUE(logs().empty());
}

}  // namespace
}  // namespace scarab::logger::test
