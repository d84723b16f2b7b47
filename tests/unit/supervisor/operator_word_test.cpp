#include "services/supervisor/core/operator_word.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/unit/supervisor/scripted_robot.hpp"

// What an operator can make the machine do, and what not.
namespace scarab::supervisor {
namespace {

using testing::HasSubstr;
using Inputs = std::array<double, 4>;

constexpr double kTiltedRad = 0.18;  // as the robot stands on the object

constexpr std::array<Mode, 7> kModes = {Mode::kStop,     Mode::kForward, Mode::kBackward,
                                        Mode::kSoftPush, Mode::kBoxing,  Mode::kStationary,
                                        Mode::kHardPush};

TEST(OperatorWord, HoldsEveryModeFromEveryRunningState) {
  for (const Mode mode : kModes) {
    for (const int ticks_before : {0, 3, 12, 30}) {
      ScriptedRobot robot("soft+hard");
      robot.pitch_rad = kTiltedRad;
      robot.ticks(ticks_before);
      ASSERT_EQ(robot.tell(mode_word(mode)), "");
      const std::uint32_t told = robot.next_tick();
      const Decision decision = robot.ticks(100);
      EXPECT_EQ(decision.state, State::kManual);
      EXPECT_EQ(decision.mode, mode);
      EXPECT_EQ(decision.inputs, inputs_of(f2_config(), mode));
      EXPECT_EQ(decision.hind_override, mode == Mode::kStationary);
      EXPECT_EQ(decision.entered_tick, told) << "entered once";
      EXPECT_THAT(reason(decision), HasSubstr("operator: mode " + std::string(name(mode))));
    }
  }
}

TEST(OperatorWord, HoldsInputsWhateverTheSensorsSay) {
  const Inputs inputs = {0.25, -1, 1, -0.7};
  ScriptedRobot robot = on_the_object("soft+hard");
  ASSERT_EQ(robot.tell(inputs_word(inputs)), "");
  robot.front_f_rad = 0.5;
  for (int i = 0; i < 100; ++i) {
    const Decision decision = robot.tick();
    ASSERT_EQ(decision.state, State::kManual);
    ASSERT_EQ(decision.inputs, inputs);
    ASSERT_NE(decision.mode, Mode::kStop) << "inputs move the robot";
    ASSERT_FALSE(decision.hind_override);
  }
}

TEST(OperatorWord, NamesInputsAfterTheNearestMode) {
  const SupervisorConfig config = f2_config();
  for (const Mode mode :
       {Mode::kForward, Mode::kBackward, Mode::kSoftPush, Mode::kBoxing, Mode::kHardPush}) {
    Inputs inputs = inputs_of(config, mode);
    EXPECT_EQ(nearest_mode(config, inputs), mode);
    inputs[3] += 0.05;
    EXPECT_EQ(nearest_mode(config, inputs), mode);
  }
}

TEST(OperatorWord, LastWordCounts) {
  ScriptedRobot robot("soft");
  robot.tick();
  ASSERT_EQ(robot.tell(mode_word(Mode::kForward)), "");
  ASSERT_EQ(robot.tell(inputs_word({1, 0, 0, 1})), "");
  EXPECT_EQ(robot.tick().inputs, (Inputs{1, 0, 0, 1}));
  ASSERT_EQ(robot.tell(mode_word(Mode::kBoxing)), "");
  EXPECT_EQ(robot.tick().mode, Mode::kBoxing);
}

TEST(OperatorWord, AutomaticGoesOnFromTheApproach) {
  ScriptedRobot robot = on_the_object("soft+hard");
  ASSERT_EQ(robot.tell(mode_word(Mode::kStop)), "");
  robot.ticks(5);
  ASSERT_EQ(robot.tell({}), "");
  Decision decision = robot.tick();
  EXPECT_EQ(decision.state, State::kApproach);
  EXPECT_EQ(decision.mode, Mode::kBackward);
  EXPECT_THAT(reason(decision), HasSubstr("automatic"));
  EXPECT_EQ(robot.tick().state, State::kClimb) << "still on the object";
  EXPECT_EQ(robot.until(State::kMode1).mode, Mode::kSoftPush);
}

TEST(OperatorWord, AutomaticChangesNothingThatIsAutomatic) {
  ScriptedRobot robot = on_the_object("soft+hard");
  const std::uint32_t entered = robot.state.entered_tick;
  ASSERT_EQ(robot.tell({}), "");
  const Decision decision = robot.tick();
  EXPECT_EQ(decision.state, State::kMode1);
  EXPECT_EQ(decision.entered_tick, entered);
}

TEST(OperatorWord, StrategyIsFollowedFromItsApproachOn) {
  ScriptedRobot robot = on_the_object("soft+hard");
  ASSERT_EQ(robot.tell(strategy_word("boxing")), "");
  EXPECT_EQ(robot.tick().state, State::kApproach);
  EXPECT_EQ(robot.until(State::kMode1).mode, Mode::kBoxing);
  robot.front_f_rad = 0.9;
  EXPECT_EQ(robot.ticks(100).state, State::kMode1) << "it has no mode 2";
  ASSERT_EQ(robot.tell(strategy_word("walk-forward")), "");
  const Decision walking = robot.ticks(50);
  EXPECT_EQ(walking.state, State::kApproach);
  EXPECT_EQ(walking.mode, Mode::kForward);
}

TEST(OperatorWord, AutomaticGivesBackToTheChosenStrategy) {
  ScriptedRobot robot("stand");
  robot.tick();
  ASSERT_EQ(robot.tell(strategy_word("walk-forward")), "");
  ASSERT_EQ(robot.tell(mode_word(Mode::kBoxing)), "");
  robot.tick();
  ASSERT_EQ(robot.tell({}), "");
  EXPECT_EQ(robot.tick().mode, Mode::kForward);
}

TEST(OperatorWord, StrategyEndsManualDriving) {
  ScriptedRobot robot("soft");
  robot.tick();
  ASSERT_EQ(robot.tell(mode_word(Mode::kForward)), "");
  robot.tick();
  ASSERT_EQ(robot.tell(strategy_word("soft")), "");
  EXPECT_EQ(robot.tick().state, State::kApproach);
}

/// What may not be taken, and what the refusal must say.
struct Refused {
  OperatorWord word;
  const char* says;
};

class RefusedWord : public testing::TestWithParam<Refused> {};

TEST_P(RefusedWord, ChangesNothing) {
  for (const bool manual : {false, true}) {
    ScriptedRobot robot = on_the_object("soft+hard");
    if (manual) {
      ASSERT_EQ(robot.tell(mode_word(Mode::kBoxing)), "");
      robot.tick();
    }
    const MachineState before = robot.state;
    EXPECT_THAT(robot.tell(GetParam().word), HasSubstr(GetParam().says));
    EXPECT_EQ(std::memcmp(&before, &robot.state, sizeof before), 0);
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Words, RefusedWord,
    testing::Values(Refused{strategy_word("sofd"), "unknown strategy 'sofd'; there are: boxing"},
                    Refused{strategy_word(""), "unknown strategy ''"},
                    Refused{mode_word(static_cast<Mode>(7)), "no such mode"},
                    Refused{mode_word(static_cast<Mode>(-1)), "no such mode"},
                    Refused{inputs_word({1.01, 0, 0, 0}), "I1 is 1.01, not in [-1, 1]"},
                    Refused{inputs_word({0, -1.5, 0, 0}), "I2 is -1.5, not in [-1, 1]"},
                    Refused{inputs_word({0, 0, kNan, 0}), "I3 is nan, not in [-1, 1]"},
                    Refused{inputs_word({0, 0, 0, -kInfinity}), "I4 is -inf, not in [-1, 1]"}));

TEST(OperatorWord, SafeStopAndHomingComeFirst) {
  for (const Phase phase : {Phase::kSafeStop, Phase::kHoming}) {
    ScriptedRobot robot("soft");
    robot.tick();
    ASSERT_EQ(robot.tell(mode_word(Mode::kForward)), "");
    robot.tick();
    robot.phase = phase;
    EXPECT_EQ(robot.tick().mode, Mode::kStop);
    ASSERT_EQ(robot.tell(mode_word(Mode::kBackward)), "");
    const Decision held = robot.ticks(20);
    EXPECT_EQ(held.state, State::kSafeStop);
    EXPECT_EQ(held.mode, Mode::kStop);
    EXPECT_EQ(standing(robot.state), "safe stop; after it manual: mode backward");
    robot.phase = Phase::kRunning;
    const Decision after = robot.tick();
    EXPECT_EQ(after.state, State::kManual);
    EXPECT_EQ(after.mode, Mode::kBackward) << "the last word counts";
    EXPECT_THAT(reason(after), HasSubstr("the safe stop has ended"));
  }
}

TEST(OperatorWord, AWordInTheTickOfASafeStopWaits) {
  ScriptedRobot robot("soft");
  robot.ticks(3);
  ASSERT_EQ(robot.tell(mode_word(Mode::kForward)), "");
  robot.phase = Phase::kSafeStop;
  EXPECT_EQ(robot.tick().mode, Mode::kStop);
}

TEST(OperatorWord, EndOfTheTrialComesFirst) {
  for (const Phase phase : {Phase::kSucceeded, Phase::kFailed}) {
    ScriptedRobot robot("soft");
    robot.tick();
    ASSERT_EQ(robot.tell(mode_word(Mode::kForward)), "");
    robot.phase = phase;
    EXPECT_EQ(robot.tick().mode, Mode::kStop);
    EXPECT_EQ(robot.tell(mode_word(Mode::kForward)), "the trial has ended");
    EXPECT_EQ(robot.tick().mode, Mode::kStop);
  }
}

TEST(OperatorWord, CountsFromTheFirstTickIfSaidBefore) {
  ScriptedRobot robot("soft");
  ASSERT_EQ(robot.tell(mode_word(Mode::kForward)), "");
  const Decision first = robot.tick();
  EXPECT_EQ(first.state, State::kManual);
  EXPECT_EQ(first.mode, Mode::kForward);
  EXPECT_EQ(first.entered_tick, 0U);
}

TEST(OperatorWord, NewTrialBeginsAutomatic) {
  ScriptedRobot robot("soft");
  robot.tick();
  ASSERT_EQ(robot.tell(strategy_word("walk-forward")), "");
  ASSERT_EQ(robot.tell(mode_word(Mode::kBoxing)), "");
  robot.state = robot.machine.initial_state();
  const Decision decision = robot.tick();
  EXPECT_EQ(decision.state, State::kApproach);
  EXPECT_EQ(decision.mode, Mode::kBackward);
}

TEST(OperatorWord, SignalsGoOnUnderTheHand) {
  ScriptedRobot driven("soft");
  ScriptedRobot automatic("soft");
  driven.tick();
  automatic.tick();
  ASSERT_EQ(driven.tell(mode_word(Mode::kStop)), "");
  for (int i = 0; i < 30; ++i) {
    driven.pitch_rad = automatic.pitch_rad = 0.1 * std::sin(0.3 * i);
    const Decision a = driven.tick();
    const Decision b = automatic.tick();
    ASSERT_EQ(a.bs_rad, b.bs_rad);
    ASSERT_EQ(a.as_rad, b.as_rad);
  }
}

TEST(OperatorWord, OutlivesTheProcessBitByBit) {
  ScriptedRobot whole("soft+hard");
  whole.ticks(4);
  ASSERT_EQ(whole.tell(strategy_word("boxing+hard")), "");
  ASSERT_EQ(whole.tell(inputs_word({0.1, 0.2, 0.3, 0.4})), "");
  whole.tick();
  ScriptedRobot fresh("soft+hard");
  std::memcpy(static_cast<void*>(&fresh.state), &whole.state, sizeof(MachineState));
  EXPECT_EQ(fresh.tick().inputs, (Inputs{0.1, 0.2, 0.3, 0.4}));
  ASSERT_EQ(fresh.tell({}), "");
  fresh.pitch_rad = kTiltedRad;
  EXPECT_EQ(fresh.until(State::kMode1).mode, Mode::kBoxing);
}

TEST(OperatorWord, ReasonIsKeptAndCut) {
  ScriptedRobot robot("soft");
  robot.tick();
  auto word = mode_word(Mode::kForward);
  word.reason = "to the window";
  ASSERT_EQ(robot.tell(word), "");
  EXPECT_EQ(reason(robot.tick()), "operator: mode forward: to the window");
  word.reason = std::string(500, 'x');
  ASSERT_EQ(robot.tell(word), "");
  EXPECT_EQ(reason(robot.tick()).size(), std::tuple_size_v<Reason> - 1);
}

TEST(OperatorWord, SaysWhatHolds) {
  ScriptedRobot robot("soft");
  robot.tick();
  EXPECT_EQ(standing(robot.state), "automatic: the trial's strategy");
  ASSERT_EQ(robot.tell(inputs_word({1, -1, 0.5, -0.3})), "");
  EXPECT_EQ(standing(robot.state), "manual: inputs 1 -1 0.5 -0.3");
  ASSERT_EQ(robot.tell(strategy_word("hard")), "");
  EXPECT_EQ(standing(robot.state), "automatic: strategy hard");
}

}  // namespace
}  // namespace scarab::supervisor
