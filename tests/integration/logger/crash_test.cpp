/// The recorder killed, restarted, and on a full disk.
#include <cmath>

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

TEST_F(Crash, RestartedItGoesOnReportingWhatItRecords) {
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  auto first = start(arguments());
  ASSERT_TRUE(wait_for_reader(states)) << first->output();
  write(states, robot_state(4, 10));
  ASSERT_TRUE(eventually([&] { return status().recorded_tick == 10; }));
  first->signal(SIGKILL);
  ASSERT_EQ(first->wait(20s), 128 + SIGKILL);
  // The killed one counts as a reader for 10 s still; the sample is kept for the new one.
  auto second = start(arguments());
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
