#include "tests/integration/tick_master/fixture.hpp"

/// A trial on a body with motors, from its begin to its rest.
namespace scarab::test {
namespace {

using testing::ElementsAre;

class Trial : public MasterOfABody {
 protected:
  /// The calls but advance(), without repetitions.
  [[nodiscard]] std::vector<Call> course() const {
    std::vector<Call> course;
    for (const Call call : body_->calls()) {
      if (call != Call::kAdvance && (course.empty() || course.back() != call)) {
        course.push_back(call);
      }
    }
    return course;
  }
};

TEST_F(Trial, CallsEveryHookInItsTurn) {
  start({});
  ASSERT_TRUE(begin());
  EXPECT_TRUE(shows(scarab_LIFECYCLE_ACTIVE));
  ASSERT_TRUE(answer_until(0.1, [&] { return applied(0.1); }));
  say(scarab_OPERATOR_STOP, "lunch");
  ASSERT_TRUE(answer_until(0.1, [&] { return is_in(scarab_PHASE_FAILED); }));
  EXPECT_TRUE(says("trial 1 ended: failure: operator stop: lunch"));
  EXPECT_TRUE(shows(scarab_LIFECYCLE_INACTIVE));
  EXPECT_THAT(course(), ElementsAre(Call::kBegin, Call::kActivate, Call::kStart, Call::kSafeStop,
                                    Call::kEnd, Call::kRest));
  const auto report = status_.await(self_, [](const auto&) { return true; });
  ASSERT_TRUE(report);
  for (const char* name : {"tick_cycle", "tick_jitter", "tick_overrun", "command_age"}) {
    EXPECT_EQ(report->histograms.count(name), 1U) << name;
  }
}

TEST_F(Trial, EndOfTheProcessTakesThePowerAway) {
  start({});
  ASSERT_TRUE(begin());
  ASSERT_TRUE(answer_until(0.1, [&] { return applied(0.1); }));
  stop();
  EXPECT_EQ(body_->calls().back(), Call::kRest);
}

TEST_F(Trial, ANewerOneLeavesItWithThePowerOff) {
  start({});
  ASSERT_TRUE(begin(1));
  ASSERT_TRUE(answer_until(0.1, [&] { return applied(0.1); }));
  ASSERT_TRUE(begin(2));
  EXPECT_THAT(course(), ElementsAre(Call::kBegin, Call::kActivate, Call::kStart, Call::kRest,
                                    Call::kBegin, Call::kActivate, Call::kStart));
}

/// In 20 ms ticks at 0.5 rad/s: 0.01 rad a tick.
TEST_F(Trial, AFarPoseIsLeftSlowlyBeforeTheFirstTick) {
  constexpr double kFar = -1.2;  // beyond the range
  constexpr double kStep = 0.01;
  start({});
  body_->change([&](auto& fate) { fate.stands_rad = kFar; });
  ASSERT_TRUE(eventually([&] { return !sensors_.matched().empty(); }));
  ends_.tell_trial(1);
  ASSERT_TRUE(says("homing"));
  ASSERT_TRUE(
      eventually([&] { return !sensors_.all().empty() && ends_.states().count(1, 0) > 0; }));
  const auto first = ends_.states().await(1, 0);
  EXPECT_EQ(first->phase, scarab_PHASE_RUNNING);
  EXPECT_EQ(first->header.sim_time_ns, 0);
  EXPECT_EQ(first->position_rad[0], 0);

  double before_rad = kFar;
  std::size_t steps = 0;
  for (const auto& entry : body_->log()) {
    if (entry.call == Call::kStart) break;
    if (entry.call != Call::kAdvance) continue;
    EXPECT_LE(std::abs(entry.target_rad - before_rad), kStep + 1e-9);
    before_rad = entry.target_rad;
    ++steps;
  }
  EXPECT_EQ(before_rad, 0);
  EXPECT_GE(steps, static_cast<std::size_t>(-kFar / kStep));
  // By the wall clock, and shown on the way.
  const auto begun = body_->last(Call::kActivate)->time;
  EXPECT_GE(body_->last(Call::kStart)->time - begun, steps * std::chrono::milliseconds(18));
  const auto& seen = sensors_.all();
  EXPECT_GE(std::count_if(seen.begin(), seen.end(),
                          [](const auto& s) { return s.phase == scarab_PHASE_HOMING; }),
            static_cast<std::ptrdiff_t>(steps));
}

TEST_F(Trial, AStopOnTheWayHomeEndsItWithTheFirstTick) {
  start({});
  body_->change([](auto& fate) { fate.stands_rad = -1; });
  ends_.tell_trial(1);
  ASSERT_TRUE(says("homing"));
  say(scarab_OPERATOR_STOP);
  const auto only = ends_.states().await(1, 0);
  ASSERT_TRUE(only);
  EXPECT_EQ(only->phase, scarab_PHASE_FAILED);
  EXPECT_LT(only->position_rad[0], -0.1);
}

TEST_F(Trial, NoOtherTickMasterMayBeThere) {
  start({});
  bus::Participant other(test_options("plant"));
  runtime::StatusPublisher status(other, {"plant", 0});
  status.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
  status.publish_if_due();
  body_->change([](auto& fate) { fate.configured = false; });
  ends_.tell_trial(1);
  ASSERT_TRUE(says("no other tick master (found plant/0)"));
  body_->change([](auto& fate) { fate.configured = true; });
  ASSERT_TRUE(says("waits for no other tick master"));
  EXPECT_EQ(ends_.states().count(1, 0), 0U);
  status.set_lifecycle(scarab_LIFECYCLE_FINALISED);
  status.publish_if_due();
  EXPECT_TRUE(ends_.states().await(1, 0));
}

/// Nobody stands by there to end a safe stop.
TEST_F(Trial, InLockstepWhatTheBodyThrowsEndsIt) {
  Options options;
  options.pace = runtime::Pace::kLockstep;
  start(options);
  ASSERT_TRUE(begin(1));
  ASSERT_TRUE(answer_until(0.1, [&] { return applied(0.1); }));
  body_->change([](auto& fate) { fate.advance_throws = "no longer finite"; });
  ASSERT_TRUE(answer_until(0.1, [&] { return body_->count(Call::kRest) > 0; }));
  const auto report = status_.await_health(self_, scarab_HEALTH_FAULT);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->message, "trial 1: no longer finite");
  body_->change([](auto& fate) { fate.advance_throws.clear(); });
  ASSERT_TRUE(begin(2));
  EXPECT_TRUE(answer_until(0.2, [&] { return applied(0.2); }));
}

}  // namespace
}  // namespace scarab::test
