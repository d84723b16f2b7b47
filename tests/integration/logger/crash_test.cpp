/// The recorder killed, restarted, and on a full disk.
#include <cmath>

#include "common/mcap/recover.hpp"
#include "tests/integration/logger/fixture.hpp"

namespace scarab::logger::test {
namespace {

using testing::HasSubstr;

class Crash : public LoggerTest {
 protected:
  Crash() {
    mcap::test::write_file(folder_ / "small.yaml",
                           std::string_view("chunk_size_kib: 16\nchunk_time_s: 0.05\n"));
  }
  std::vector<std::string> arguments() const {
    return {"--output", (folder_ / "x.mcap").string(), "--config",
            (folder_ / "small.yaml").string()};
  }
};

TEST_F(Crash, KilledAtAnyMomentEveryClosedChunkIsThere) {
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  std::string name = "x.mcap";
  for (int kill = 0; kill < 3; ++kill) {
    const std::size_t first = sent_[states.topic()].size();
    auto logger = start(arguments());
    ASSERT_TRUE(wait_for_reader(states)) << logger->output();
    const auto active = folder_ / (name + ".active");
    std::uint64_t closed_chunks = 0;
    // Publish until some chunks are closed; then kill at a moment that differs each time.
    const std::uint32_t trial = static_cast<std::uint32_t>(kill) + 1;
    std::uint32_t tick = 0;
    ASSERT_TRUE(eventually([&] {
      if (may_write(trial, tick)) write(states, robot_state(trial, tick++));
      closed_chunks = mcap::Reader(active).summary().statistics.chunk_count;
      return closed_chunks >= static_cast<std::uint64_t>(2 + kill);
    })) << logger->output();
    const Samples before_the_kill = read_samples(active);
    for (int more = 0; more < 17 * kill; ++more) write(states, robot_state(trial, tick++));
    logger->signal(SIGKILL);
    ASSERT_EQ(logger->wait(20s), 128 + SIGKILL);

    ASSERT_TRUE(eventually([&] { return states.matched().empty(); }));
    const auto mended = folder_ / ("mended-" + name);
    mcap::recover(active, mended);
    EXPECT_TRUE(mcap::Reader(mended).closed());
    const auto recorded = read_samples(mended)["scarab/robot_state"];
    EXPECT_GE(recorded.size(), before_the_kill.at("scarab/robot_state").size());
    // The first sample may be the last of the run before: one is kept for late joiners.
    const auto& sent = sent_.at(states.topic());
    const std::size_t skipped = first > 0 && recorded.at(0) == sent.at(first - 1) ? 1 : 0;
    ASSERT_LE(recorded.size(), sent.size() - first + skipped);
    EXPECT_TRUE(std::equal(recorded.begin(), recorded.end(),
                           sent.begin() + static_cast<std::ptrdiff_t>(first - skipped)))
        << "a gap or a changed sample";
    // The next one leaves the file alone and takes another name.
    name = "x-" + std::to_string(kill + 2) + ".mcap";
  }
}

TEST_F(Crash, RestartedItGoesOnReportingWhatItRecords) {
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  auto first = start(arguments());
  ASSERT_TRUE(wait_for_reader(states)) << first->output();
  write(states, robot_state(4, 10));
  ASSERT_TRUE(eventually([&] { return status().recorded_tick == 10; }));
  first->signal(SIGKILL);
  ASSERT_EQ(first->wait(20s), 128 + SIGKILL);
  ASSERT_TRUE(eventually([&] { return states.matched().empty(); }));
  auto second = start(arguments());
  ASSERT_TRUE(wait_for_reader(states)) << second->output();
  write(states, robot_state(4, 11));
  ASSERT_TRUE(eventually([&] { return status().recorded_tick == 11; })) << second->output();
  EXPECT_EQ(status().recorded_trial, 4U);
  EXPECT_EQ(status().health, scarab_HEALTH_OK);
  second->signal(SIGTERM);
  EXPECT_EQ(second->wait(20s), 0);
  EXPECT_TRUE(mcap::Reader(folder_ / "x-2.mcap").closed());
}

TEST_F(Crash, AFullDiskEndsItWithAClearErrorAndAReadableFile) {
  // A limit on the size of files stands for the full disk; ulimit counts in units of 512 bytes.
  const std::string command = "ulimit -f 200; exec " SCARAB_BIN_DIR "/scarab-logger --tag " + tag_ +
                              " --output " + (folder_ / "x.mcap").string() + " --config " +
                              (folder_ / "small.yaml").string();
  scarab::test::ChildProcess logger({"/bin/sh", "-c", command}, folder_ / "full.log");
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  ASSERT_TRUE(wait_for_reader(states)) << logger.output();
  std::uint32_t tick = 0;
  ASSERT_TRUE(eventually(
      [&] {
        if (may_write(1, tick)) {
          scarab_RobotState state = robot_state(1, tick++);
          // Nothing that zstd could make much smaller.
          for (std::uint32_t i = 0; i < 19; ++i)
            state.velocity_rad_s[i] = std::sin(tick * (i + 1.0));
          write(states, state);
        }
        return logger.wait(0ms).has_value();
      },
      60s))
      << logger.output();
  EXPECT_EQ(logger.wait(0ms), 1);
  EXPECT_THAT(logger.output(), HasSubstr("x.mcap.active: File too large"));
  const auto recorded = read_samples(folder_ / "x.mcap.active")["scarab/robot_state"];
  ASSERT_GT(recorded.size(), 50U);
  EXPECT_TRUE(std::equal(recorded.begin(), recorded.end(), sent_[states.topic()].begin()));
}

}  // namespace
}  // namespace scarab::logger::test
