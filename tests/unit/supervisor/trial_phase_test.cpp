#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/supervisor/core/behaviour_machine.hpp"
#include "tests/unit/supervisor/scripted_robot.hpp"

// How the machine follows the trial's phase, as the tick master announces it.
namespace scarab::supervisor {
namespace {

constexpr double kTiltedRad = 0.18;          // as the robot stands on the object
constexpr double kBlockedRad = 1.013 - 0.1;  // front F-joints pressed back by a blocked object

struct Ending {
  Phase phase;
  State state;
};

class EndOfTrial : public testing::TestWithParam<Ending> {};

TEST_P(EndOfTrial, IsFinalFromEveryState) {
  for (const int ticks_before : {0, 3, 12, 30}) {
    ScriptedRobot robot("soft+hard");
    robot.pitch_rad = kTiltedRad;
    robot.ticks(ticks_before);
    robot.phase = GetParam().phase;
    const Decision decision = robot.tick();
    EXPECT_EQ(decision.state, GetParam().state);
    EXPECT_EQ(decision.mode, Mode::kStop);
    EXPECT_THAT(reason(decision), testing::HasSubstr("tick master"));
    robot.phase = Phase::kRunning;
    EXPECT_EQ(robot.ticks(10).state, GetParam().state) << "for good";
  }
}

INSTANTIATE_TEST_SUITE_P(Phases, EndOfTrial,
                         testing::Values(Ending{Phase::kSucceeded, State::kDone},
                                         Ending{Phase::kFailed, State::kFailed}));

TEST(TrialPhase, StopsWithTheSafeStopAndApproachesAgainAfterIt) {
  ScriptedRobot robot = on_the_object("soft+hard");
  const std::uint32_t stopped = robot.next_tick();
  robot.phase = Phase::kSafeStop;
  Decision decision = robot.ticks(50);
  EXPECT_EQ(decision.state, State::kSafeStop);
  EXPECT_EQ(decision.mode, Mode::kStop);
  EXPECT_EQ(decision.entered_tick, stopped) << "entered once";
  robot.phase = Phase::kRunning;
  robot.pitch_rad = 0;  // homed, off the object
  decision = robot.tick();
  EXPECT_EQ(decision.state, State::kApproach);
  EXPECT_EQ(decision.mode, Mode::kBackward);
  EXPECT_EQ(robot.ticks(100).state, State::kApproach);
}

TEST(TrialPhase, HoldsStillWhileHoming) {
  ScriptedRobot robot = on_the_object("soft+hard");
  robot.phase = Phase::kSafeStop;
  robot.ticks(10);
  const std::uint32_t homing = robot.next_tick();
  robot.phase = Phase::kHoming;
  const Decision decision = robot.ticks(30);
  EXPECT_EQ(decision.state, State::kSafeStop);
  EXPECT_EQ(decision.mode, Mode::kStop);
  EXPECT_EQ(reason(decision), "homing");
  EXPECT_EQ(decision.entered_tick, homing);
  robot.phase = Phase::kSafeStop;  // a second emergency stop on the way home
  EXPECT_THAT(reason(robot.tick()), testing::HasSubstr("safe stop"));
  robot.phase = Phase::kHoming;
  robot.tick();
  robot.phase = Phase::kRunning;
  EXPECT_EQ(robot.tick().state, State::kApproach);
}

TEST(TrialPhase, FindsTheObjectAgainAfterASafeStop) {
  ScriptedRobot robot = on_the_object("soft+hard");
  robot.front_f_rad = kBlockedRad;
  robot.until(State::kMode2);
  robot.phase = Phase::kSafeStop;
  robot.ticks(10);
  robot.phase = Phase::kRunning;
  EXPECT_EQ(robot.tick().state, State::kApproach);
  EXPECT_EQ(robot.tick().state, State::kClimb) << "still tilted";
  EXPECT_EQ(robot.ticks(5).state, State::kMode1) << "after settling again";
  EXPECT_EQ(robot.ticks(30).state, State::kMode1) << "disarmed again";
}

}  // namespace
}  // namespace scarab::supervisor
