#include "tests/integration/tick_master/fixture.hpp"

/// A body whose device is not there, or not fit for a trial.
namespace scarab::test {
namespace {

using testing::HasSubstr;

class Device : public MasterOfABody {};

TEST_F(Device, IsWaitedForBeforeATrial) {
  start({});
  body_->change([](auto& fate) { fate.configured = false; });
  EXPECT_TRUE(shows(scarab_LIFECYCLE_UNCONFIGURED));
  EXPECT_TRUE(says("waits for the test's device"));
  ends_.tell_trial(1);
  ASSERT_TRUE(eventually([&] { return body_->count(Call::kBegin) == 1; }));
  ASSERT_TRUE(says("waits for the test's device"));
  const auto waiting = status_.await(self_, [](const auto&) { return true; });
  ASSERT_TRUE(waiting);
  EXPECT_EQ(waiting->health, scarab_HEALTH_WAITING);
  EXPECT_EQ(waiting->ready_trial, 0U);
  EXPECT_EQ(ends_.states().count(1, 0), 0U);
  EXPECT_EQ(body_->count(Call::kActivate), 0U);

  body_->change([](auto& fate) { fate.configured = true; });
  EXPECT_TRUE(ends_.states().await(1, 0));
  EXPECT_TRUE(status_.await_ready(self_, 1));
  EXPECT_TRUE(shows(scarab_LIFECYCLE_ACTIVE));
}

TEST_F(Device, AFaultKeepsATrialFromStarting) {
  start({});
  body_->change([](auto& fate) { fate.fault = "the robot lies on its side"; });
  ends_.tell_trial(1);
  ASSERT_TRUE(says("the end of a fault: the robot lies on its side"));
  EXPECT_EQ(body_->count(Call::kActivate), 0U);
  body_->change([](auto& fate) { fate.fault.reset(); });
  const auto first = ends_.states().await(1, 0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->phase, scarab_PHASE_RUNNING) << "nothing moved that would have to be reset";
}

TEST_F(Device, AnotherTrialMayComeWhileItIsWaitedFor) {
  start({});
  body_->change([](auto& fate) { fate.configured = false; });
  ends_.tell_trial(1);
  ASSERT_TRUE(eventually([&] { return body_->count(Call::kBegin) == 1; }));
  ends_.tell_trial(2);
  ASSERT_TRUE(eventually([&] { return body_->count(Call::kBegin) == 2; }));
  body_->change([](auto& fate) { fate.configured = true; });
  EXPECT_TRUE(ends_.states().await(2, 0));
}

TEST_F(Device, ThatDoesNotComeOnRefusesTheTrial) {
  start({});
  body_->change([](auto& fate) { fate.activate_throws = "no answer from TL0"; });
  ends_.tell_trial(1);
  const auto report = status_.await_health(self_, scarab_HEALTH_FAULT);
  ASSERT_TRUE(report);
  EXPECT_THAT(report->message, HasSubstr("trial 1: no answer from TL0"));
  EXPECT_EQ(report->lifecycle, scarab_LIFECYCLE_INACTIVE);
  EXPECT_EQ(body_->calls().back(), Call::kRest);
  EXPECT_EQ(ends_.states().count(1, 0), 0U);
  body_->change([](auto& fate) { fate.activate_throws.clear(); });
  ASSERT_TRUE(begin(2));
  EXPECT_TRUE(answer_until(0.1, [&] { return applied(0.1); }));
}

TEST_F(Device, CanBeReadBetweenTrials) {
  start({});
  body_->change([](auto& fate) { fate.tells_idle = true, fate.stands_rad = -0.4; });
  const auto state = sensors_.await(0, 0);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->position_rad[0], -0.4);
  EXPECT_EQ(body_->count(Call::kActivate), 0U);
}

}  // namespace
}  // namespace scarab::test
