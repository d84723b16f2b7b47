#include <iostream>

#include "tests/integration/tick_master/fixture.hpp"

/// What brings the safe stop of a body with motors, and what it takes to leave it.
namespace scarab::test {
namespace {

using std::chrono::milliseconds;

class SafeStop : public MasterOfABody {
 protected:
  /// In a trial, with a command applied.
  void walk(const Options& options, double angle_rad) {
    start(options);
    ASSERT_TRUE(begin());
    ASSERT_TRUE(answer_until(angle_rad, [&] { return applied(angle_rad); }));
  }
  /// All that was applied since the last stop.
  [[nodiscard]] std::vector<double> targets_since_stop() const {
    std::vector<double> targets;
    for (const auto& entry : body_->log()) {
      if (entry.call == Call::kSafeStop) targets.clear();
      if (entry.call == Call::kAdvance) targets.push_back(entry.target_rad);
    }
    return targets;
  }
};

TEST_F(SafeStop, ComesAtOnceInTheMiddleOfATickAndHolds) {
  Options options;
  options.tick_period = milliseconds(1000);
  walk(options, 0.1);
  const auto tick = *body_->last(Call::kAdvance);
  const auto said = RecordingBody::Clock::now();
  say(scarab_OPERATOR_EMERGENCY_STOP, "smoke");
  ASSERT_TRUE(eventually([&] { return body_->count(Call::kSafeStop) > 0; }));
  const auto stopped = body_->last(Call::kSafeStop)->time;
  std::cout << "from the word to the body: "
            << std::chrono::duration<double, std::milli>(stopped - said).count() << " ms\n";
  EXPECT_LT(stopped - said, milliseconds(100));
  EXPECT_LT(stopped - tick.time, options.tick_period) << "not in the middle of the tick";
  EXPECT_TRUE(says("safe stop: operator emergency stop: smoke"));
  ASSERT_TRUE(answer_until(0.3, [&] { return targets_since_stop().size() >= 2; }));
  for (const double target_rad : targets_since_stop()) EXPECT_EQ(target_rad, tick.target_rad);
  EXPECT_EQ(body_->count(Call::kActivate), 1U);
}

TEST_F(SafeStop, OfMissingCommandsIsToldToTheBodyToo) {
  Options options;
  options.stale_ticks_limit = 5;
  start(options);
  ASSERT_TRUE(begin());
  ASSERT_TRUE(eventually([&] { return body_->count(Call::kSafeStop) > 0; }));
  EXPECT_TRUE(says("safe stop: no valid joint_command for 5 ticks"));
  EXPECT_EQ(body_->count(Call::kSafeStop), 1U);
}

TEST_F(SafeStop, AfterAResetTheMotorsComeOnAndTheRobotGoesHome) {
  walk({}, 0.3);
  say(scarab_OPERATOR_EMERGENCY_STOP, "smoke");
  ASSERT_TRUE(answer_until(0.3, [&] { return is_in(scarab_PHASE_SAFE_STOP); }));
  say(scarab_OPERATOR_RESET);
  ASSERT_TRUE(answer_until(0.3, [&] { return is_in(scarab_PHASE_HOMING); }));
  EXPECT_EQ(body_->count(Call::kActivate), 2U);
  ASSERT_TRUE(answer_until(0.2, [&] { return is_in(scarab_PHASE_RUNNING) && applied(0.2); }));
  double before_rad = 0.3;
  const auto targets = targets_since_stop();
  std::size_t home = 0;
  for (; home < targets.size() && before_rad != 0; ++home) {
    EXPECT_LE(std::abs(targets[home] - before_rad), 0.01 + 1e-9);
    before_rad = targets[home];
  }
  EXPECT_GE(home, 30U);
}

TEST_F(SafeStop, OfAFaultCannotBeResetWhileItLasts) {
  walk({}, 0.1);
  body_->change([](auto& fate) { fate.fault = "TL0 is too hot"; });
  ASSERT_TRUE(answer_until(0.1, [&] { return is_in(scarab_PHASE_SAFE_STOP); }));
  EXPECT_EQ(body_->count(Call::kSafeStop), 1U);
  EXPECT_TRUE(says("safe stop: TL0 is too hot"));
  EXPECT_TRUE(shows(scarab_LIFECYCLE_INACTIVE));
  say(scarab_OPERATOR_RESET);
  EXPECT_TRUE(says("safe stop: TL0 is too hot; reset refused: TL0 is too hot"));
  EXPECT_EQ(body_->count(Call::kActivate), 1U);

  body_->change([](auto& fate) { fate.fault.reset(); });
  EXPECT_TRUE(is_in(scarab_PHASE_SAFE_STOP)) << "it takes a reset";
  say(scarab_OPERATOR_RESET);
  ASSERT_TRUE(answer_until(0.2, [&] { return is_in(scarab_PHASE_RUNNING) && applied(0.2); }));
  EXPECT_EQ(body_->count(Call::kActivate), 2U);
  EXPECT_TRUE(shows(scarab_LIFECYCLE_ACTIVE));
}

/// The status follows the motors, not the end of the tick that is under way.
TEST_F(SafeStop, WithoutTorqueIsNotActive) {
  Options options;
  options.tick_period = milliseconds(500);
  walk(options, 0.1);
  body_->change([](auto& fate) { fate.stops_without_torque = true; });
  say(scarab_OPERATOR_EMERGENCY_STOP);
  ASSERT_TRUE(shows(scarab_LIFECYCLE_INACTIVE));
  EXPECT_TRUE(is_in(scarab_PHASE_RUNNING)) << "the tick of the stop is not over";
  say(scarab_OPERATOR_RESET);
  ASSERT_TRUE(shows(scarab_LIFECYCLE_ACTIVE));
  say(scarab_OPERATOR_STOP, "lunch");
  ASSERT_TRUE(shows(scarab_LIFECYCLE_INACTIVE));
  EXPECT_FALSE(is_in(scarab_PHASE_FAILED)) << "the trial's last tick is to come";
}

/// A last answer that nobody gives is waited for; the motors are off meanwhile.
TEST_F(SafeStop, AtTheEndIsNotActive) {
  walk({}, 0.1);
  body_->change([](auto& fate) { fate.verdict = {true, "there"}; });
  ASSERT_TRUE(eventually([&] { return is_in(scarab_PHASE_SUCCEEDED); }));
  const auto report =
      status_.await(self_, [](const auto& r) { return r.lifecycle == scarab_LIFECYCLE_INACTIVE; });
  ASSERT_TRUE(report);
  EXPECT_EQ(report->message, "") << "the trial has not ended yet";
}

TEST_F(SafeStop, StaysWhereTheMotorsDoNotComeOn) {
  walk({}, 0.1);
  say(scarab_OPERATOR_EMERGENCY_STOP);
  ASSERT_TRUE(answer_until(0.1, [&] { return is_in(scarab_PHASE_SAFE_STOP); }));
  body_->change([](auto& fate) { fate.activate_throws = "no answer from TL0"; });
  say(scarab_OPERATOR_RESET);
  EXPECT_TRUE(says("reset refused: no answer from TL0"));
  EXPECT_TRUE(is_in(scarab_PHASE_SAFE_STOP));
  body_->change([](auto& fate) { fate.activate_throws.clear(); });
  say(scarab_OPERATOR_RESET);
  EXPECT_TRUE(answer_until(0.2, [&] { return is_in(scarab_PHASE_RUNNING) && applied(0.2); }));
}

TEST_F(SafeStop, ComesForWhatTheBodyThrows) {
  walk({}, 0.1);
  body_->change([](auto& fate) { fate.observe_throws = "the line is cut"; });
  ASSERT_TRUE(answer_until(0.1, [&] { return is_in(scarab_PHASE_SAFE_STOP); }));
  EXPECT_TRUE(says("safe stop: the line is cut"));
  EXPECT_EQ(ends_.states().all().back().position_source[0], scarab_SOURCE_ABSENT);
  body_->change([](auto& fate) { fate.observe_throws.clear(); });
  ASSERT_TRUE(answer_until(0.1, [&] { return ends_.states().all().back().position_rad[0] != 0; }));
  say(scarab_OPERATOR_RESET);
  ASSERT_TRUE(answer_until(0.1, [&] { return body_->count(Call::kActivate) == 2; }));
  body_->change([](auto& fate) { fate.advance_throws = "the line is cut again"; });
  ASSERT_TRUE(answer_until(0.1, [&] { return body_->count(Call::kSafeStop) == 2; }));
  EXPECT_TRUE(says("safe stop: the line is cut again"));
}

TEST_F(SafeStop, BetweenTrialsKeepsTheMotorsOfTheNextOff) {
  start({});
  say(scarab_OPERATOR_EMERGENCY_STOP, "hands in the way");
  ASSERT_TRUE(says("hands in the way"));
  const auto state = begin();
  ASSERT_TRUE(state);
  EXPECT_EQ(state->phase, scarab_PHASE_SAFE_STOP);
  EXPECT_EQ(body_->count(Call::kActivate), 0U);
  say(scarab_OPERATOR_RESET);
  EXPECT_TRUE(answer_until(0.2, [&] { return applied(0.2); }));
  EXPECT_EQ(body_->count(Call::kActivate), 1U);
}

}  // namespace
}  // namespace scarab::test
