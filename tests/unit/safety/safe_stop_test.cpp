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

TEST(SafeStop, OutlivesTheTrial) {
  CommandGate gate = ready_gate();
  gate.emergency_stop("operator");
  gate.end_trial();
  gate.begin_trial(2, all(0.3));
  gate.expect(0);
  gate.offer(position(0, 0.1, 2));
  EXPECT_TRUE(gate.in_safe_stop());
  EXPECT_EQ(gate.target_rad()[0], 0.3);
}

TEST(SafeStop, NeverThrows) {
  static_assert(noexcept(std::declval<CommandGate&>().emergency_stop(std::string())));
  static_assert(noexcept(std::declval<CommandGate&>().reset()));
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

TEST(Homing, IsSlowUntilEachJointHasCaughtUp) {
  CommandGate gate = ready_gate();
  gate.emergency_stop("operator");
  gate.reset();
  EXPECT_TRUE(gate.homing());
  EXPECT_EQ(gate.target_rad()[0], 0.0) << "nothing moves before the next command";
  constexpr double kHomingWindow = 0.05;  // 0.5 rad/s for a tick
  for (std::uint32_t tick = 1; tick <= 10; ++tick) {
    EXPECT_TRUE(gate.homing());
    gate.expect(tick);
    gate.offer(position(tick, 0.5));
    EXPECT_NEAR(gate.target_rad()[0], kHomingWindow * tick, 1e-12);
  }
  gate.expect(11);
  gate.offer(position(11, 0.5));
  EXPECT_FALSE(gate.homing());
  gate.expect(12);
  gate.offer(position(12, -1));
  EXPECT_NEAR(gate.target_rad()[0], 0.5 - kWindow, 1e-12) << "full speed again";
}

TEST(Homing, EndsForAJointThatMeetsAMovingCommand) {
  CommandGate gate = ready_gate();
  gate.emergency_stop("operator");
  gate.reset();
  std::uint32_t tick = 0;
  for (; gate.homing() && tick < 100; ++tick) {
    gate.expect(tick);
    gate.offer(position(tick, 0.4 * std::cos(0.6 * tick)));
  }
  EXPECT_LT(tick, 20U);
}

TEST(Homing, IsNeededOnlyAfterASafeStop) {
  CommandGate gate = ready_gate();
  gate.reset();
  EXPECT_FALSE(gate.homing());
  gate.offer(position(0, 0.5));
  EXPECT_NEAR(gate.target_rad()[0], kWindow, 1e-12);
}

}  // namespace
}  // namespace scarab::safety
