#include <cmath>
#include <limits>
#include <set>

#include "tests/integration/plant/fixture.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using Lockstep = PlantProcess;

TEST_F(Lockstep, EachTickComesOnceAndInOrder) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 39)) << child_.err();
  const auto& states = ends_.states().all();
  ASSERT_EQ(states.size(), 41U);
  for (std::uint32_t tick = 0; tick <= 40; ++tick) {
    EXPECT_EQ(states[tick].header.tick, tick);
    EXPECT_EQ(states[tick].header.sim_time_ns, tick * 100'000'000LL);
    EXPECT_EQ(states[tick].phase, scarab_PHASE_RUNNING);
  }
}

TEST_F(Lockstep, SensorsComeBetweenTheTicks) {
  bus::Participant view(test_options("view"));
  Inbox<scarab_RobotState> sensors(view, bus::kRobotSensors);
  ASSERT_TRUE(eventually([&] { return !sensors.matched().empty(); }));
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 9)) << child_.err();
  std::set<std::int64_t> times;
  ASSERT_TRUE(eventually([&] { return sensors.all().size() >= 40; }));
  for (const auto& sample : sensors.all()) times.insert(sample.header.sim_time_ns);
  EXPECT_EQ(times.size(), sensors.all().size());  // none twice
  for (const auto& state : ends_.states().all()) {
    EXPECT_EQ(times.count(state.header.sim_time_ns), 0U);  // nor what robot_state says already
  }
}

TEST_F(Lockstep, WaitsForTheCommandAndSaysWhoIsSilent) {
  const auto state = begin();
  ASSERT_TRUE(state);
  ASSERT_TRUE(status_.await_message(self_, "supervisor has not answered tick 0"));
  ends_.behave(*state);
  ASSERT_TRUE(status_.await_message(self_, "premotor has not answered tick 0"));
  EXPECT_EQ(ends_.states().count(1, 1), 0U);
  ends_.command(ChainEnds::command_for(*state));
  EXPECT_TRUE(ends_.states().await(1, 1)) << child_.err();
  EXPECT_TRUE(healthy());
}

TEST_F(Lockstep, SilenceOfTheSupervisorEndsTheTrial) {
  ASSERT_TRUE(begin());
  const auto verdict = world_.await(1, std::chrono::seconds(30));
  ASSERT_TRUE(verdict) << child_.err();
  EXPECT_EQ(verdict->verdict, scarab_VERDICT_FAILURE);
  EXPECT_THAT(verdict->reason, StartsWith("supervisor has not answered tick 0 for 10 s"));
  EXPECT_TRUE(status_.await_health(self_, scarab_HEALTH_FAULT));
  EXPECT_TRUE(begin(2)) << "the next trial is none the worse for it";
}

TEST_F(Lockstep, SilenceOfThePremotorEndsTheTrial) {
  ASSERT_TRUE(begin());
  const auto state = ends_.run(1, 0, 4);
  ASSERT_TRUE(state);
  ends_.behave(*state);
  const auto verdict = world_.await(1, std::chrono::seconds(30));
  ASSERT_TRUE(verdict) << child_.err();
  EXPECT_EQ(verdict->verdict, scarab_VERDICT_FAILURE);
  EXPECT_THAT(verdict->reason, StartsWith("premotor has not answered tick 5 for 10 s"));
}

TEST_F(Lockstep, RefusesAndCountsWhatIsNoAnswer) {
  ASSERT_TRUE(begin(2));
  const auto state = ends_.run(2, 0, 69);  // further than the gate remembers
  ASSERT_TRUE(state) << child_.err();
  const auto good = ChainEnds::command_for(*state);
  auto wrong_trial = good;
  wrong_trial.header.trial = 1;
  auto stale = good;
  stale.header.tick = 0;
  auto future = good;
  future.header.tick = 71;
  auto not_a_number = good;
  not_a_number.position_rad[3] = std::numeric_limits<double>::quiet_NaN();
  for (const auto& bad : {wrong_trial, stale, future, not_a_number}) ends_.command(bad);
  const auto report = status_.await_message(self_, "not finite");
  ASSERT_TRUE(report) << child_.err();
  EXPECT_EQ(report->health, scarab_HEALTH_DEGRADED);
  EXPECT_THAT(report->message, HasSubstr("joint_command 70"));
  EXPECT_EQ(ends_.states().count(2, 71), 0U);
  ends_.answer(*state);
  ASSERT_TRUE(ends_.states().await(2, 71)) << child_.err();
  for (const auto* counter : {"commands_refused_trial", "commands_refused_stale",
                              "commands_refused_future", "commands_refused_finite"}) {
    EXPECT_TRUE(counted(counter, 1)) << counter;
  }
  EXPECT_TRUE(counted("commands_accepted", 71));
}

TEST_F(Lockstep, TwoDifferentAnswersToOneTickAreReported) {
  const auto state = begin();
  ASSERT_TRUE(state);
  ends_.answer(*state);
  const auto next = ends_.states().await(1, 1);
  ASSERT_TRUE(next);
  auto different = ChainEnds::command_for(*state);
  different.position_rad[0] += 0.25;
  ends_.command(different);
  const auto report = status_.await_message(self_, "two different joint_command 0");
  ASSERT_TRUE(report) << child_.err();
  EXPECT_EQ(report->health, scarab_HEALTH_DEGRADED);
  ends_.answer(*next);
  EXPECT_TRUE(ends_.states().await(1, 2));
  EXPECT_TRUE(counted("commands_refused_conflict", 1));
}

TEST_F(Lockstep, TheSameAnswerAgainIsFine) {
  const auto state = begin();
  ASSERT_TRUE(state);
  ends_.answer(*state);
  ends_.answer(*state);
  const auto next = ends_.run(1, 1, 5);
  ASSERT_TRUE(next) << child_.err();
  EXPECT_TRUE(counted("commands_duplicate", 1));
  ends_.answer(*next);
  EXPECT_TRUE(healthy());
}

TEST_F(Lockstep, MorePremotorsThanExpectedStopTheStart) {
  {
    bus::Participant spare(test_options("premotor", 1));
    const bus::Writer<scarab_JointCommand> writer(spare, bus::kJointCommand);
    ASSERT_TRUE(eventually([&] { return !writer.matched().empty(); }));
    ends_.tell_trial(1);
    ASSERT_TRUE(
        status_.await_message(self_, "only 1 premotor to write scarab/joint_command (found 2)"));
    EXPECT_EQ(ends_.states().count(1, 0), 0U);
  }
  EXPECT_TRUE(ends_.states().await(1, 0)) << child_.err();
}

TEST_F(Lockstep, StartsOnlyWhenEveryoneIsReady) {
  ends_.tell_trial(1);
  ASSERT_TRUE(ends_.states().await(1, 0));
  ends_.say_ready(1);  // for the trial before
  ASSERT_TRUE(ends_.run(1, 0, 2));
  bus::Participant other(test_options("experiment", 1));
  bus::Writer<scarab_Trial> trials(other, bus::kTrial);
  ASSERT_TRUE(eventually([&] { return !trials.matched().empty(); }));
  scarab_Trial trial{};
  trial.header.trial = 2;
  trial.goal = scarab_GOAL_NONE;
  trial.time_limit_s = 10;
  trials.write(trial);
  const auto report = status_.await_message(self_, "to be ready");
  ASSERT_TRUE(report) << child_.err();
  EXPECT_THAT(report->message,
              AllOf(HasSubstr("premotor/0 to be ready"), HasSubstr("supervisor/0 to be ready")));
  EXPECT_EQ(ends_.states().count(2, 0), 0U);
  ends_.say_ready(2);
  EXPECT_TRUE(ends_.states().await(2, 0));
}

TEST_F(Lockstep, TheTickOfTheVerdictIsTheLast) {
  ASSERT_TRUE(eventually([&] { return world_.matched(); }));
  ends_.tell_trial(1, 1.0);  // goal none: the time limit is the success
  ASSERT_TRUE(ends_.run(1, 0, 9)) << child_.err();
  const auto last = ends_.states().await(1, 10);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->phase, scarab_PHASE_SUCCEEDED);
  ends_.answer(*last);
  const auto verdict = world_.await(1);
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->verdict, scarab_VERDICT_SUCCESS);
  EXPECT_EQ(verdict->header.tick, 10U);
  ASSERT_TRUE(status_.await(self_, [](const auto& report) {
    return report.lifecycle == scarab_LIFECYCLE_INACTIVE && report.header.tick == 10;
  }));
  EXPECT_EQ(ends_.states().count(1, 11), 0U);
}

TEST_F(Lockstep, EndsCleanlyInTheMiddleOfATrial) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 3));
  EXPECT_EQ(child_.stop(), 0) << child_.err();
}

}  // namespace
}  // namespace scarab::test
