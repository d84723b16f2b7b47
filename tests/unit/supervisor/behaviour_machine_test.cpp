#include "services/supervisor/core/behaviour_machine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "tests/unit/supervisor/scripted_robot.hpp"

namespace scarab::supervisor {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTiltedRad = 0.18;          // as the robot stands on the object
constexpr double kBlockedRad = 1.013 - 0.1;  // front F-joints pressed back by a blocked object

/// BS follows the pitch at once, so that a test can set it.
SupervisorConfig unfiltered() {
  SupervisorConfig config = f2_config();
  config.bs.smoothing = 1;
  return config;
}

TEST(BehaviourMachine, IsIdleBeforeTheFirstTick) {
  const ScriptedRobot robot("soft");
  EXPECT_EQ(robot.state.state, State::kIdle);
}

TEST(BehaviourMachine, ApproachesBackwardFromTheFirstTick) {
  ScriptedRobot robot("soft+hard");
  const Decision decision = robot.tick();
  EXPECT_EQ(decision.state, State::kApproach);
  EXPECT_EQ(decision.mode, Mode::kBackward);
  EXPECT_EQ(decision.inputs, (std::array<double, 4>{0, 1, 0, 0}));
  EXPECT_EQ(decision.entered_tick, 0U);
}

TEST(BehaviourMachine, KeepsApproachingOnTheLevel) {
  ScriptedRobot robot("soft+hard");
  robot.front_f_rad = kBlockedRad;  // AS alone must not switch anything before mode 1
  robot.pitch_rad = 0.0436;         // the steepest that walking was seen to be
  EXPECT_EQ(robot.ticks(600).state, State::kApproach);
}

TEST(BehaviourMachine, ClimbsAsSoonAsTheFilteredPitchPassesTheThreshold) {
  ScriptedRobot robot("soft");
  robot.tick();
  robot.pitch_rad = kTiltedRad;
  // BS = 0.18 (1 - 0.8^n) > 0.15 from n = 9 on.
  EXPECT_EQ(robot.ticks(8).state, State::kApproach);
  const Decision decision = robot.tick();
  EXPECT_EQ(decision.state, State::kClimb);
  EXPECT_EQ(decision.mode, Mode::kBackward) << "still walks backward";
  EXPECT_EQ(decision.entered_tick, 9U);
  EXPECT_NEAR(decision.bs_rad, kTiltedRad * (1 - std::pow(0.8, 9)), 1e-12);
  EXPECT_EQ(decision.bs_threshold_rad, 0.15);
  EXPECT_EQ(reason(decision), "BS 0.156 > 0.150 rad");
}

TEST(BehaviourMachine, DoesNotClimbAtTheThresholdItself) {
  ScriptedRobot robot("soft", unfiltered());
  robot.pitch_rad = 0.15;
  EXPECT_EQ(robot.ticks(50).state, State::kApproach);
}

TEST(BehaviourMachine, SettlesBeforeMode1) {
  ScriptedRobot robot("soft", unfiltered());
  robot.tick();
  robot.pitch_rad = 0.153;
  EXPECT_EQ(robot.ticks(5).state, State::kClimb);
  const Decision decision = robot.tick();  // the sixth tick over the threshold
  EXPECT_EQ(decision.state, State::kMode1);
  EXPECT_EQ(decision.mode, Mode::kSoftPush);
  EXPECT_EQ(decision.inputs, (std::array<double, 4>{1, -1, 1, 1}));
  EXPECT_EQ(decision.entered_tick, 6U);
  EXPECT_EQ(reason(decision), "BS 0.153 > 0.150 rad for 6 ticks");
}

TEST(BehaviourMachine, ApproachesAgainIfBsFallsBackWhileSettling) {
  ScriptedRobot robot("soft", unfiltered());
  robot.tick();
  robot.pitch_rad = kTiltedRad;
  EXPECT_EQ(robot.ticks(5).state, State::kClimb);
  robot.pitch_rad = 0.15;
  const Decision back = robot.tick();
  EXPECT_EQ(back.state, State::kApproach);
  EXPECT_THAT(reason(back), testing::HasSubstr("BS 0.150 fell back"));
  robot.pitch_rad = kTiltedRad;
  EXPECT_EQ(robot.ticks(5).state, State::kClimb) << "the settling time begins anew";
  EXPECT_EQ(robot.tick().state, State::kMode1);
}

TEST(BehaviourMachine, StaysInMode1WhenBsFalls) {
  ScriptedRobot robot = on_the_object("soft+hard");
  robot.pitch_rad = 0;
  EXPECT_EQ(robot.ticks(300).state, State::kMode1);
}

TEST(BehaviourMachine, SwitchesToMode2WhenAsFalls) {
  ScriptedRobot robot = on_the_object("soft+hard");
  EXPECT_EQ(robot.ticks(60).state, State::kMode1) << "AS at its reference";
  robot.front_f_rad = kBlockedRad;
  const Decision decision = robot.until(State::kMode2);
  EXPECT_EQ(decision.state, State::kMode2);
  EXPECT_EQ(decision.mode, Mode::kHardPush);
  EXPECT_EQ(decision.inputs, (std::array<double, 4>{1, 0, 0, -0.3}));
  EXPECT_NEAR(decision.as_threshold_rad, 1.013 - 0.062, 1e-12);
  EXPECT_LT(decision.as_rad, decision.as_threshold_rad);
  EXPECT_THAT(reason(decision), testing::MatchesRegex("AS 0\\.9[0-9]+ < 0\\.951 rad for 3 ticks"));
}

TEST(BehaviourMachine, NeedsConsecutiveTicksBelow) {
  SupervisorConfig config = f2_config();
  config.as.window_ticks = 1;  // AS follows the joint at once
  ScriptedRobot robot = on_the_object("soft+hard", config);
  robot.ticks(40);
  for (int i = 0; i < 20; ++i) {
    robot.front_f_rad = kBlockedRad;
    ASSERT_EQ(robot.ticks(2).state, State::kMode1) << "two of three";
    robot.front_f_rad = 1.0;
    ASSERT_EQ(robot.tick().state, State::kMode1);
  }
  robot.front_f_rad = kBlockedRad;
  EXPECT_EQ(robot.ticks(3).state, State::kMode2);
}

TEST(BehaviourMachine, DoesNotSwitchAtTheThresholdItself) {
  SupervisorConfig config = f2_config();
  config.as.window_ticks = 1;
  ScriptedRobot robot = on_the_object("soft+hard", config);
  robot.front_f_rad = config.as.reference_rad - config.as.drop_rad;
  EXPECT_EQ(robot.ticks(200).state, State::kMode1);
}

TEST(BehaviourMachine, IsNotArmedAtTheStartOfMode1) {
  ScriptedRobot robot = on_the_object("soft+hard");
  const std::uint32_t entered = robot.state.entered_tick;
  robot.front_f_rad = kBlockedRad;
  // Armed from 30 ticks after, then 3 ticks below: the 32nd tick after mode 1 began.
  const Decision decision = robot.until(State::kMode2);
  EXPECT_EQ(decision.entered_tick, entered + 30 + 2);
}

TEST(BehaviourMachine, IgnoresTheRippleOfTheStep) {
  // The F-joints give by 3 deg in the rhythm of the CPG; their mean lies 0.04 rad under the
  // reference, over the threshold.
  ScriptedRobot robot = on_the_object("soft+hard");
  for (int i = 0; i < 600; ++i) {
    robot.front_f_rad = 1.013 - 0.04 + 0.052 * std::sin(6.283185307179586 * i / 14.433);
    ASSERT_EQ(robot.tick().state, State::kMode1) << "tick " << i;
  }
}

TEST(BehaviourMachine, StaysInMode2) {
  ScriptedRobot robot = on_the_object("soft+hard");
  robot.front_f_rad = kBlockedRad;
  robot.until(State::kMode2);
  robot.front_f_rad = 1.2;
  robot.pitch_rad = 0;
  EXPECT_EQ(robot.ticks(300).state, State::kMode2);
}

TEST(BehaviourMachine, SingleModeNeverSwitches) {
  ScriptedRobot robot = on_the_object("soft");
  robot.front_f_rad = kBlockedRad;
  const Decision decision = robot.ticks(300);
  EXPECT_EQ(decision.state, State::kMode1);
  EXPECT_LT(decision.as_rad, decision.as_threshold_rad) << "AS is still reported";
}

TEST(BehaviourMachine, OutlivesReadingsThatAreNotFinite) {
  ScriptedRobot robot("soft+hard");
  robot.ticks(5);
  robot.pitch_rad = kNan;
  robot.front_f_rad = kNan;
  const Decision blind = robot.ticks(5);
  EXPECT_TRUE(std::isfinite(blind.bs_rad) && std::isfinite(blind.as_rad));
  EXPECT_EQ(blind.state, State::kApproach);
  robot.pitch_rad = kTiltedRad;
  robot.front_f_rad = 1.013;
  EXPECT_EQ(robot.until(State::kMode1).state, State::kMode1);
}

TEST(BehaviourMachine, NeverSwitchesWithoutFrontAngles) {
  ScriptedRobot robot("soft+hard");
  robot.front_f_rad = kNan;
  robot.pitch_rad = kTiltedRad;
  EXPECT_EQ(robot.ticks(300).state, State::kMode1);
}

TEST(BehaviourMachine, GoesOnFromACopiedStateBitByBit) {
  ScriptedRobot whole("soft+hard");
  for (int tick = 0; tick < 160; ++tick) {
    std::array<unsigned char, sizeof(MachineState)> file{};
    std::memcpy(file.data(), &whole.state, sizeof(MachineState));
    ScriptedRobot fresh("soft+hard");
    std::memcpy(static_cast<void*>(&fresh.state), file.data(), sizeof(MachineState));

    Perception perception;
    perception.tick = static_cast<std::uint32_t>(tick);
    perception.pitch_rad = tick < 20 ? 0.01 * std::sin(tick) : kTiltedRad;
    const double f = (tick < 90 ? 1.013 : kBlockedRad) + 0.02 * std::sin(0.4353 * tick);
    perception.front_f_rad = {f, f + 0.01};
    perception.measured.front_angle = true;
    const Decision a = whole.machine.step(whole.state, perception);
    const Decision b = fresh.machine.step(fresh.state, perception);
    ASSERT_EQ(std::memcmp(&whole.state, &fresh.state, sizeof(MachineState)), 0) << "tick " << tick;
    ASSERT_EQ(a.state, b.state);
    ASSERT_EQ(a.mode, b.mode);
    ASSERT_EQ(a.reason, b.reason);
    ASSERT_EQ(a.bs_rad, b.bs_rad);
    ASSERT_EQ(a.as_rad, b.as_rad);
  }
  EXPECT_EQ(whole.state.state, State::kMode2) << "the script went through all states";
}

TEST(BehaviourMachine, HoldsTheBackboneInEveryState) {
  ScriptedRobot robot("soft+hard");
  EXPECT_EQ(robot.tick().backbone_rad, 0.05);
  robot.pitch_rad = kTiltedRad;
  EXPECT_EQ(robot.until(State::kMode1).backbone_rad, 0.05);
  robot.phase = Phase::kSafeStop;
  EXPECT_EQ(robot.tick().backbone_rad, 0.05);
}

TEST(BehaviourMachine, RefusesParametersOutOfRange) {
  const auto refused = [](const auto& set) {
    SupervisorConfig config = f2_config();
    set(config);
    EXPECT_THROW(BehaviourMachine(config, find_strategy(config, "soft")), std::invalid_argument);
  };
  refused([](SupervisorConfig& c) { c.bs.smoothing = 0; });
  refused([](SupervisorConfig& c) { c.bs.smoothing = 1.1; });
  refused([](SupervisorConfig& c) { c.bs.threshold_rad = kNan; });
  refused([](SupervisorConfig& c) { c.bs.settle_ticks = 1; });
  refused([](SupervisorConfig& c) { c.as.window_ticks = 0.5; });
  refused([](SupervisorConfig& c) { c.as.window_ticks = 64.5; });
  refused([](SupervisorConfig& c) { c.as.drop_rad = kNan; });
  refused([](SupervisorConfig& c) { c.as.confirm_ticks = 0; });
  refused([](SupervisorConfig& c) { c.backbone_rad = kNan; });
  refused([](SupervisorConfig& c) { c.strategies["soft"].push.resize(3); });
}

}  // namespace
}  // namespace scarab::supervisor
