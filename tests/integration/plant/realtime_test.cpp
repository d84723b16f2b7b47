#include <sched.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <vector>

#include "common/bus/clock.hpp"
#include "tests/integration/plant/fixture.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kTickNs = 100'000'000;
// Late by what a loaded machine takes, but not drifting; and never early.
constexpr std::int64_t kEarlyNs = 2'000'000;
constexpr std::int64_t kLateNs = 1'000'000'000;

class RealTime : public PlantProcess {
 protected:
  RealTime() : PlantProcess({"--pace", "realtime"}) {}

  std::optional<StatusWatch::Report> report_at(std::uint32_t tick) {
    return status_.await(self_, [&](const auto& report) { return report.header.tick >= tick; });
  }
};

TEST_F(RealTime, TicksFollowTheWallClock) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 19)) << child_.err();
  const auto& states = ends_.states().all();
  for (std::uint32_t tick = 1; tick <= 20; ++tick) {
    const std::int64_t since = states[tick].header.stamp_ns - states[0].header.stamp_ns;
    EXPECT_GE(since, tick * kTickNs - kEarlyNs) << "tick " << tick;
    EXPECT_LE(since, tick * kTickNs + kLateNs) << "tick " << tick;
    EXPECT_TRUE(states[tick].real_time);
  }
}

TEST_F(RealTime, SensorSamplesFollowItToo) {
  bus::Participant view(test_options("view"));
  Inbox<scarab_RobotState> sensors(view, bus::kRobotSensors);
  ASSERT_TRUE(eventually([&] { return !sensors.matched().empty(); }));
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 9)) << child_.err();
  const scarab_Header first = ends_.states().all().front().header;
  ASSERT_GE(sensors.all().size(), 36U);  // four between two ticks
  for (const auto& sample : sensors.all()) {
    const std::int64_t late =
        sample.header.stamp_ns - first.stamp_ns - (sample.header.sim_time_ns - first.sim_time_ns);
    EXPECT_GE(late, -kEarlyNs) << sample.header.sim_time_ns;
    EXPECT_LE(late, kLateNs) << sample.header.sim_time_ns;
  }
}

TEST_F(RealTime, MeasuresHowWellItKeepsTime) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 29)) << child_.err();
  const auto report = report_at(25);
  ASSERT_TRUE(report);
  // Of each tick until then, and never more than there were.
  for (const char* name : {"tick_jitter", "command_age"}) {
    ASSERT_EQ(report->histograms.count(name), 1U) << name;
    const auto& histogram = report->histograms.at(name);
    EXPECT_GE(histogram.total(), 25U) << name;
    EXPECT_LE(histogram.total(), 31U) << name;
    EXPECT_GT(histogram.sum_s(), 0) << name;
  }
  EXPECT_LT(report->histograms.at("tick_jitter").quantile_s(0.5), 0.05);
  // A tick's work takes a hundredth of its time: most do not overrun.
  EXPECT_LT(report->histograms.at("tick_overrun").total(), 10U);
}

TEST_F(RealTime, CommandsThatStopComingBringTheSafeStop) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 4));
  const std::uint32_t answered = ends_.states().all().back().header.tick;
  std::optional<std::uint32_t> stopped;
  ASSERT_TRUE(eventually([&] {
    const auto& last = ends_.states().all().back();
    if (last.phase == scarab_PHASE_SAFE_STOP) stopped = last.header.tick;
    return stopped.has_value();
  })) << child_.err();
  EXPECT_GE(*stopped, answered + 2);  // one late command is no reason
  EXPECT_TRUE(counted("safe_stops", 1));
  EXPECT_TRUE(status_.await_message(self_, "safe stop: no valid joint_command"));
  // Commands that come again do not end it: that takes a reset.
  const std::uint32_t next = *stopped + 1;
  ASSERT_TRUE(ends_.run(1, next, next + 3));
  EXPECT_EQ(ends_.states().all().back().phase, scarab_PHASE_SAFE_STOP);
}

TEST_F(RealTime, ACommandAfterItsDeadlineIsCountedAndNoReasonToStop) {
  ASSERT_TRUE(begin());
  for (std::uint32_t tick = 0; tick < 8; ++tick) {
    const auto state = ends_.states().await(1, tick);
    ASSERT_TRUE(state) << child_.err();
    const std::int64_t answer_at_ns = state->header.stamp_ns + kTickNs / 2;  // deadline: a fifth
    ASSERT_TRUE(eventually([&] { return bus::now_ns() >= answer_at_ns; }));
    ends_.answer(*state);
  }
  const auto report = status_.await(self_, [](const auto& r) {
    const auto late = r.counters.find("commands_late");
    return late != r.counters.end() && late->second >= 4;
  });
  ASSERT_TRUE(report) << child_.err();
  EXPECT_EQ(report->counters.at("safe_stops"), 0U);
  EXPECT_GE(report->histograms.at("command_age").max_s(), 0.05);
}

/// What was missed is over: the robot must not be sent a burst of old ticks.
TEST_F(RealTime, AStoppedProcessDoesNotCatchUpWithABurst) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 4));
  child_.signal(SIGSTOP);
  const std::int64_t until_ns = bus::now_ns() + 6 * kTickNs;
  ASSERT_TRUE(eventually([&] { return bus::now_ns() >= until_ns; }));
  child_.signal(SIGCONT);
  ASSERT_TRUE(ends_.run(1, 5, 14)) << child_.err();
  const auto& states = ends_.states().all();
  // Over any five ticks after it: no more than its one late tick is made good.
  for (std::size_t i = 7; i + 5 < states.size(); ++i) {
    EXPECT_GE(states[i + 5].header.stamp_ns - states[i].header.stamp_ns, 3 * kTickNs) << i;
  }
  const auto report = report_at(12);
  ASSERT_TRUE(report);
  EXPECT_GE(report->histograms.at("tick_overrun").max_s(), 0.3);
}

TEST_F(RealTime, SaysWhatTheSystemGrants) {
  const auto report =
      status_.await(self_, [](const auto& r) { return r.counters.count("priority_raised") == 1; });
  ASSERT_TRUE(report) << child_.err();
  const bool raised = sched_getscheduler(child_.pid()) == SCHED_FIFO;
  EXPECT_EQ(report->counters.at("priority_raised"), raised ? 1U : 0U);
  EXPECT_EQ(child_.err().find("priority is not raised") == std::string::npos, raised);
#if !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)  // their mlockall() does nothing
  const std::string status = read_text("/proc/" + std::to_string(child_.pid()) + "/status");
  const bool locked = status.find("VmLck:\t       0 kB") == std::string::npos;
  EXPECT_EQ(report->counters.at("memory_locked"), locked ? 1U : 0U) << status;
  EXPECT_EQ(child_.err().find("memory is not locked") == std::string::npos, locked);
#endif
}

/// Without rights it works as well, and says what would help.
TEST(RealTimeWithoutRights, SaysWhatIsMissing) {
  const TemporaryDirectory run_dir;
  Arguments command = {"/usr/bin/prlimit", "--memlock=65536:65536", "--rtprio=0:0"};
  if (geteuid() == 0) {  // limits do not count for root
    const Arguments drop = {"/usr/bin/setpriv", "--bounding-set", "-all", "--inh-caps", "-all"};
    command.insert(command.begin(), drop.begin(), drop.end());
  }
  for (const auto& word : {program("scarab-plant"), std::string("--pace"), std::string("realtime"),
                           std::string("--tag"), test_tag()}) {
    command.push_back(word);
  }
  for (const auto& file : shipped_files("plant")) command.push_back(file);
  ChildProcess plant(command, run_dir / "plant");
  StatusWatch status;
  const auto report = status.await(
      {"plant", 0}, [](const auto& r) { return r.counters.count("memory_locked") == 1; });
  ASSERT_TRUE(report) << plant.err();
  EXPECT_EQ(report->counters.at("memory_locked"), 0U);
  EXPECT_EQ(report->counters.at("priority_raised"), 0U);
  EXPECT_THAT(plant.err(),
              HasSubstr("memory is not locked: the limit memlock (ulimit -l) is 64 kB"));
  EXPECT_THAT(plant.err(), HasSubstr("make the limit rtprio (ulimit -r) 20 or more"));
}

}  // namespace
}  // namespace scarab::test
