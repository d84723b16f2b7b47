#include <gtest/gtest.h>

#include <cmath>

#include "common/safety/command_gate.hpp"
#include "tests/unit/safety/small_robot.hpp"

namespace scarab::safety {
namespace {

TEST(SafeStop, HoldsTheLastTargetsWhateverIsCommanded) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.1));
  gate.emergency_stop("operator");
  for (std::uint32_t tick = 1; tick < 20; ++tick) {
    gate.expect(tick);
    const Verdict verdict = gate.offer(position(tick, -0.5));
    EXPECT_EQ(verdict.outcome, Outcome::kSafeStop);
    EXPECT_TRUE(verdict.answers) << "the chain goes on, only the servos do not";
    EXPECT_EQ(gate.target_rad()[0], 0.1);
  }
  EXPECT_TRUE(gate.in_safe_stop());
  EXPECT_EQ(gate.safe_stop_reason(), "operator");
}

TEST(SafeStop, KeepsItsFirstReasonAndCountsOnce) {
  CommandGate gate = ready_gate();
  gate.emergency_stop("operator");
  gate.emergency_stop("over-temperature");
  EXPECT_EQ(gate.safe_stop_reason(), "operator");
  EXPECT_EQ(gate.counters().safe_stops, 1U);
}

TEST(SafeStop, OfAPersonTakesOverFromTheGatesOwn) {
  CommandGate gate = ready_gate(2);
  for (std::uint32_t tick = 1; !gate.in_safe_stop(); ++tick) gate.expect(tick);
  gate.emergency_stop("operator");
  EXPECT_EQ(gate.safe_stop_reason(), "operator");
  EXPECT_EQ(gate.counters().safe_stops, 1U);
  gate.expect(50);
  gate.expect(60);
  EXPECT_EQ(gate.safe_stop_reason(), "operator");
  gate.reset(gate.target_rad());
  gate.emergency_stop("operator, again");
  EXPECT_EQ(gate.safe_stop_reason(), "operator, again");
}

TEST(SafeStop, OfTheRobotKeepsItsFirstReasonAndIsLatchedAllTheSame) {
  CommandGate gate = ready_gate();
  gate.offer(position(0, 0.1));
  gate.safe_stop("TL0 is too hot");
  gate.safe_stop("TL1 is too hot");
  for (std::uint32_t tick = 1; tick < 5; ++tick) {
    gate.expect(tick);
    EXPECT_EQ(gate.offer(position(tick, -0.5)).outcome, Outcome::kSafeStop);
  }
  EXPECT_EQ(gate.target_rad()[0], 0.1);
  EXPECT_EQ(gate.safe_stop_reason(), "TL0 is too hot");
  EXPECT_EQ(gate.counters().safe_stops, 1U);
  gate.emergency_stop("operator");
  EXPECT_EQ(gate.safe_stop_reason(), "operator");
}

TEST(SafeStop, OutlivesTheTrial) {
  CommandGate gate = ready_gate();
  gate.emergency_stop("operator");
  gate.end_trial();
  gate.begin_trial(2, all(0.3), all(0.3));
  gate.expect(0);
  gate.offer(position(0, 0.1, 2));
  EXPECT_TRUE(gate.in_safe_stop());
  EXPECT_EQ(gate.target_rad()[0], 0.3);
}

TEST(SafeStop, NeverThrows) {
  static_assert(noexcept(std::declval<CommandGate&>().emergency_stop(std::string())));
  static_assert(noexcept(std::declval<CommandGate&>().safe_stop(std::string())));
  static_assert(noexcept(std::declval<CommandGate&>().end_trial()));
  CommandGate gate(small_robot(), kTickPeriod);  // not even in a trial
  gate.emergency_stop("crash");
  EXPECT_TRUE(gate.in_safe_stop());
}

TEST(SafeStop, ComesWhenCommandsStayAway) {
  CommandGate gate = ready_gate(3);
  gate.offer(position(0, 0.1));
  for (std::uint32_t tick = 1; tick <= 3; ++tick) {
    gate.expect(tick);
    EXPECT_FALSE(gate.in_safe_stop()) << "tick " << tick;
  }
  gate.expect(4);  // 1, 2 and 3 went without an answer
  EXPECT_TRUE(gate.in_safe_stop());
  EXPECT_EQ(gate.safe_stop_reason(), "no valid joint_command for 3 ticks");
}

TEST(SafeStop, DoesNotComeForSingleGapsOrInLockstep) {
  CommandGate gaps = ready_gate(2), lockstep = ready_gate(0);
  for (std::uint32_t tick = 1; tick < 100; ++tick) {
    gaps.expect(tick);
    lockstep.expect(tick);
    if (tick % 2 == 1) gaps.offer(position(tick, 0.1));
  }
  EXPECT_FALSE(gaps.in_safe_stop());
  EXPECT_FALSE(lockstep.in_safe_stop());
}

TEST(SafeStop, RefusedCommandsDoNotKeepItAway) {
  CommandGate gate = ready_gate(2);
  for (std::uint32_t tick = 1; tick < 5; ++tick) {
    gate.offer(position(tick - 1, std::nan("")));
    gate.expect(tick);
  }
  EXPECT_TRUE(gate.in_safe_stop());
}

constexpr double kHomingWindow = 0.05;  // 0.5 rad/s for a tick

/// A gate whose joints have been brought to `away_rad` from their start at 0, stopped and reset.
CommandGate reset_gate(double away_rad, std::uint32_t& tick) {
  CommandGate gate = ready_gate();
  for (tick = 0; gate.target_rad()[0] != away_rad && tick < 100; ++tick) {
    gate.expect(tick);
    gate.offer(position(tick, away_rad));
  }
  EXPECT_EQ(gate.target_rad()[0], away_rad);
  gate.emergency_stop("operator");
  gate.expect(tick++);
  gate.reset(gate.target_rad());
  return gate;
}

TEST(Homing, GoesSlowlyToTheStartPoseBeforeCommandsCount) {
  std::uint32_t tick = 0;
  CommandGate gate = reset_gate(0.4, tick);
  EXPECT_TRUE(gate.homing());
  EXPECT_FALSE(gate.in_safe_stop());
  EXPECT_EQ(gate.target_rad()[0], 0.4) << "nothing moves before the next tick";
  double last = 0.4;
  for (const std::uint32_t end = tick + 8; tick < end; ++tick) {
    gate.expect(tick);
    EXPECT_EQ(gate.offer(position(tick, 0.9)).outcome, Outcome::kHoming);
    EXPECT_NEAR(last - gate.target_rad()[0], kHomingWindow, 1e-12);
    last = gate.target_rad()[0];
  }
  EXPECT_NEAR(last, 0, 1e-12);
  gate.expect(tick);  // home for a tick
  gate.expect(++tick);
  EXPECT_FALSE(gate.homing());
  EXPECT_EQ(gate.offer(position(tick, -1)).outcome, Outcome::kAccepted);
  EXPECT_NEAR(gate.target_rad()[0], -kWindow, 1e-12) << "full speed again";
}

TEST(Homing, AnswersTheChainMeanwhile) {
  std::uint32_t tick = 0;
  CommandGate gate = reset_gate(0.4, tick);
  gate.expect(tick);
  EXPECT_TRUE(gate.offer(position(tick, 0.4)).answers);
  EXPECT_EQ(gate.counters().of(Outcome::kHoming), 1U);
}

TEST(Homing, StopsForAnotherSafeStopAndGoesOnAfterIt) {
  std::uint32_t tick = 0;
  CommandGate gate = reset_gate(0.4, tick);
  gate.expect(tick);
  gate.emergency_stop("operator, again");
  const double held = gate.target_rad()[0];
  for (int i = 0; i < 5; ++i) gate.expect(++tick);
  EXPECT_EQ(gate.target_rad()[0], held);
  gate.reset(gate.target_rad());
  gate.expect(++tick);
  EXPECT_NEAR(gate.target_rad()[0], held - kHomingWindow, 1e-12);
}

TEST(Homing, EndsAtTheRangeOfAJointThatCannotReachItsHome) {
  CommandGate gate(small_robot(), GateOptions{kTickPeriod, 0.5, 0});
  gate.begin_trial(1, all(5.0), all(5.0));  // put there by hand, beyond the range
  gate.emergency_stop("operator");
  gate.reset(gate.target_rad());
  std::uint32_t tick = 0;
  for (; gate.homing() && tick < 1000; ++tick) gate.expect(tick);
  EXPECT_LT(tick, 1000U);
  EXPECT_LE(gate.target_rad()[0], small_robot().joints[0].max_rad);
}

TEST(Homing, BeginsWhereTheJointsStandAtTheReset) {
  std::uint32_t tick = 0;
  CommandGate gate = reset_gate(0.4, tick);
  gate.emergency_stop("operator");
  gate.reset(all(-0.2));  // moved by hand while the motors were off
  EXPECT_EQ(gate.target_rad()[0], -0.2);
  gate.expect(tick);
  EXPECT_NEAR(gate.target_rad()[0], -0.2 + kHomingWindow, 1e-12);
}

TEST(Homing, IsNotBegunFromNowhere) {
  std::uint32_t tick = 0;
  CommandGate gate = reset_gate(0.4, tick);
  gate.emergency_stop("operator");
  EXPECT_THROW(gate.reset(all(std::nan(""))), std::invalid_argument);
  EXPECT_TRUE(gate.in_safe_stop());
  EXPECT_EQ(gate.target_rad()[0], 0.4);
}

/// A robot that does not stand at its start pose when the trial begins.
CommandGate far_gate(double held_rad) {
  CommandGate gate(small_robot(), GateOptions{kTickPeriod, 0.5, 0});
  gate.begin_trial(1, all(held_rad), all(0));
  return gate;
}

TEST(Homing, LeadsToTheStartPoseBeforeTheFirstTick) {
  CommandGate gate = far_gate(-0.4);
  EXPECT_TRUE(gate.homing());
  EXPECT_EQ(gate.target_rad()[0], -0.4);
  double last = -0.4;
  int steps = 0;
  for (; gate.homing() && steps < 100; ++steps) {
    gate.advance_homing();
    EXPECT_LE(std::abs(gate.target_rad()[0] - last), kHomingWindow + 1e-12);
    last = gate.target_rad()[0];
  }
  EXPECT_GE(steps, 9) << "eight to go, and one at home";
  EXPECT_LE(steps, 10);
  EXPECT_EQ(last, 0);
  gate.expect(0);
  EXPECT_EQ(gate.offer(position(0, 0.1)).outcome, Outcome::kAccepted);
}

TEST(Homing, FromBeyondTheRangeStaysInsideItOnceItIsThere) {
  CommandGate gate = far_gate(0.8);
  double last = 0.8;
  for (int i = 0; gate.homing() && i < 100; ++i) {
    gate.advance_homing();
    EXPECT_LE(gate.target_rad()[0], last);
    last = gate.target_rad()[0];
  }
  EXPECT_FALSE(gate.homing());
  EXPECT_EQ(last, 0);
}

TEST(Homing, BeforeTheFirstTickWaitsInASafeStop) {
  CommandGate gate = far_gate(-0.4);
  gate.advance_homing();
  gate.safe_stop("the robot lies on its side");
  const double held = gate.target_rad()[0];
  for (int i = 0; i < 5; ++i) gate.advance_homing();
  EXPECT_EQ(gate.target_rad()[0], held);
  EXPECT_TRUE(gate.homing());
}

TEST(Homing, OfTheTrialBeforeIsForgotten) {
  std::uint32_t tick = 0;
  CommandGate gate = reset_gate(0.4, tick);
  ASSERT_TRUE(gate.homing());
  gate.end_trial();
  gate.begin_trial(2, all(0), all(0));
  EXPECT_FALSE(gate.homing());
}

TEST(Homing, IsNeededOnlyAfterASafeStopWhereTheRobotStandsAtHome) {
  CommandGate gate = ready_gate();
  EXPECT_FALSE(gate.homing());
  gate.reset(gate.target_rad());
  EXPECT_FALSE(gate.homing());
  gate.offer(position(0, 0.5));
  EXPECT_NEAR(gate.target_rad()[0], kWindow, 1e-12);
}

}  // namespace
}  // namespace scarab::safety
