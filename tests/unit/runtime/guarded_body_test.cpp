#include "common/runtime/guarded_body.hpp"

#include <gtest/gtest.h>

#include "tests/integration/tick_master/recording_body.hpp"
#include "tests/unit/safety/small_robot.hpp"

namespace scarab::runtime {
namespace {

using Call = test::RecordingBody::Call;

class GuardedBodyTest : public testing::Test {
 protected:
  void begin(double stands_rad = 0) {
    body_.change([&](auto& fate) { fate.stands_rad = stands_rad; });
    body_.begin(scarab_Trial{});
    guarded_.begin_trial(1);
  }
  bool observe() {
    scarab_RobotState state{};
    return guarded_.observe(state);
  }
  void set_fault(const std::optional<std::string>& fault) {
    body_.change([&](auto& fate) { fate.fault = fault; });
  }

  test::RecordingBody body_{std::chrono::milliseconds(100), 1};
  safety::CommandGate gate_{safety::small_robot(), safety::GateOptions{0.1, 0.5, 2}};
  GuardedBody guarded_{body_, gate_, OnThrow::kSafeStop};
};

TEST_F(GuardedBodyTest, ATrialBeginsWithTheMotorsOnWhereTheJointsStand) {
  begin(-0.3);
  EXPECT_EQ(body_.count(Call::kActivate), 1U);
  EXPECT_EQ(gate_.target_rad()[0], -0.3);
  EXPECT_TRUE(gate_.homing());
  EXPECT_TRUE(guarded_.active());
  guarded_.end_trial();
  EXPECT_EQ(body_.calls().back(), Call::kRest);
  EXPECT_FALSE(guarded_.active());
  EXPECT_EQ(gate_.offer({1, 0, false, {}}).outcome, safety::Outcome::kInactive);
}

TEST_F(GuardedBodyTest, WhatDoesNotComeOnIsTurnedOff) {
  body_.change([](auto& fate) { fate.activate_throws = "no answer"; });
  EXPECT_THROW(guarded_.begin_trial(1), std::runtime_error);
  EXPECT_EQ(body_.calls().back(), Call::kRest);
  EXPECT_FALSE(guarded_.active());
}

TEST_F(GuardedBodyTest, TheEndOfItTurnsTheMotorsOff) {
  {
    GuardedBody guarded(body_, gate_, OnThrow::kSafeStop);
    guarded.begin_trial(1);
  }
  EXPECT_EQ(body_.calls().back(), Call::kRest);
}

TEST_F(GuardedBodyTest, AStopThatTakesTheTorqueIsNotActive) {
  begin();
  body_.change([](auto& fate) { fate.stops_without_torque = true; });
  guarded_.emergency_stop("operator");
  EXPECT_FALSE(guarded_.active());
  ASSERT_EQ(guarded_.reset(), std::nullopt);
  EXPECT_TRUE(guarded_.active());
}

TEST_F(GuardedBodyTest, AStopThatHoldsIsActive) {
  begin();
  guarded_.emergency_stop("operator");
  EXPECT_TRUE(guarded_.active());
}

TEST_F(GuardedBodyTest, EveryBeginningOfASafeStopIsToldOnce) {
  begin();
  guarded_.emergency_stop("operator");
  guarded_.emergency_stop("operator, again");
  EXPECT_EQ(body_.count(Call::kSafeStop), 1U);
  ASSERT_EQ(guarded_.reset(), std::nullopt);
  EXPECT_EQ(body_.count(Call::kActivate), 2U);
  for (std::uint32_t tick = 0; tick < 5; ++tick) guarded_.expect(tick);  // nobody answers
  EXPECT_TRUE(gate_.in_safe_stop());
  EXPECT_EQ(body_.count(Call::kSafeStop), 2U);
  ASSERT_EQ(guarded_.reset(), std::nullopt);
  set_fault("too hot");
  observe();
  observe();
  EXPECT_EQ(body_.count(Call::kSafeStop), 3U);
  EXPECT_EQ(gate_.safe_stop_reason(), "too hot");
}

TEST_F(GuardedBodyTest, AFaultIsNotResetWhileItLasts) {
  begin();
  set_fault("too hot");
  observe();
  EXPECT_FALSE(guarded_.active());
  EXPECT_EQ(guarded_.reset(), "too hot");
  EXPECT_TRUE(gate_.in_safe_stop());
  EXPECT_EQ(body_.count(Call::kActivate), 1U);
  set_fault(std::nullopt);
  observe();
  EXPECT_TRUE(gate_.in_safe_stop());
  EXPECT_EQ(guarded_.reset(), std::nullopt);
  EXPECT_TRUE(guarded_.active());
  EXPECT_FALSE(gate_.in_safe_stop());
}

TEST_F(GuardedBodyTest, WhatItThrowsIsAFaultUntilItCanBeReadAgain) {
  begin();
  body_.change([](auto& fate) { fate.observe_throws = "cut"; });
  scarab_RobotState state{};
  state.position_rad[0] = 7;
  EXPECT_FALSE(guarded_.observe(state));
  EXPECT_EQ(state.position_rad[0], 0) << "half a state";
  EXPECT_EQ(gate_.safe_stop_reason(), "cut");
  EXPECT_EQ(guarded_.reset(), "cut");
  body_.change([](auto& fate) { fate.observe_throws.clear(); });
  EXPECT_TRUE(observe());
  EXPECT_EQ(guarded_.reset(), std::nullopt);

  body_.change([](auto& fate) { fate.advance_throws = "cut again"; });
  guarded_.advance(gate_.target_rad(), [] {});
  EXPECT_EQ(gate_.safe_stop_reason(), "cut again");
}

TEST_F(GuardedBodyTest, BetweenTrialsAFaultIsKnownButStopsNothing) {
  set_fault("too hot");
  observe();
  EXPECT_EQ(guarded_.fault(), "too hot");
  EXPECT_FALSE(gate_.in_safe_stop());
  EXPECT_EQ(body_.count(Call::kSafeStop), 0U);
}

TEST_F(GuardedBodyTest, ASafeStopFromBeforeKeepsTheMotorsOff) {
  guarded_.emergency_stop("hands in the way");
  begin();
  EXPECT_EQ(body_.count(Call::kActivate), 0U);
  EXPECT_EQ(guarded_.reset(), std::nullopt);
  EXPECT_EQ(body_.count(Call::kActivate), 1U);
}

TEST_F(GuardedBodyTest, AResetBetweenTrialsTurnsNothingOn) {
  guarded_.emergency_stop("hands in the way");
  EXPECT_EQ(guarded_.reset(), std::nullopt);
  EXPECT_FALSE(gate_.in_safe_stop());
  EXPECT_EQ(body_.count(Call::kActivate), 0U);
}

TEST_F(GuardedBodyTest, AResetThatFailsLeavesTheRobotStopped) {
  begin();
  guarded_.emergency_stop("operator");
  body_.change([](auto& fate) { fate.activate_throws = "no answer"; });
  EXPECT_EQ(guarded_.reset(), "no answer");
  EXPECT_TRUE(gate_.in_safe_stop());
  EXPECT_EQ(body_.calls().back(), Call::kSafeStop);
}

TEST_F(GuardedBodyTest, APersonsEndStopsTheBodyButNotTheGate) {
  begin();
  guarded_.end({false, "lunch"});
  EXPECT_EQ(body_.count(Call::kSafeStop), 1U);
  EXPECT_FALSE(gate_.in_safe_stop()) << "the next trial needs no reset";
  EXPECT_EQ(body_.verdict()->reason, "lunch");
}

TEST_F(GuardedBodyTest, WhereNobodyStandsByItIsPassedOn) {
  GuardedBody guarded(body_, gate_, OnThrow::kPassOn);
  guarded.begin_trial(1);
  body_.change([](auto& fate) { fate.observe_throws = fate.advance_throws = "cut"; });
  scarab_RobotState state{};
  EXPECT_THROW(guarded.observe(state), BodyFailure);
  EXPECT_THROW(guarded.advance(gate_.target_rad(), [] {}), BodyFailure);
  EXPECT_FALSE(gate_.in_safe_stop());
}

}  // namespace
}  // namespace scarab::runtime
