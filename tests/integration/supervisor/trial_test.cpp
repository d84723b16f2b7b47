#include <gmock/gmock.h>

#include <optional>
#include <set>

#include "tests/integration/responder/stand_ins.hpp"
#include "tests/integration/supervisor/supervisor_questions.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/status_watch.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class SupervisorTrial : public testing::Test {
 protected:
  const bus::Peer self_{"supervisor", 0};
  TemporaryDirectory run_dir_;
  StatusWatch status_;
  StandIns<Supervisor> stand_ins_;
  ChildProcess child_ = start({"supervisor", Supervisor::kExpect, run_dir_.path(), 0, {}});
};

TEST_F(SupervisorTrial, UnknownStrategyIsAFaultThatNamesTheKnownOnes) {
  auto trial = Supervisor::trial(1);
  bus::assign(trial.strategy, "sofd+hard");
  stand_ins_.tell(trial);
  const auto report = status_.await_health(self_, scarab_HEALTH_FAULT);
  ASSERT_TRUE(report) << child_.err();
  EXPECT_THAT(report->message, AllOf(HasSubstr("trial 1"), HasSubstr("sofd+hard"),
                                     HasSubstr("soft+hard"), HasSubstr("boxing")));
  EXPECT_NE(report->ready_trial, 1U);
  stand_ins_.tell_trial(2);  // and the next good trial is none the worse for it
  ASSERT_TRUE(status_.await_ready(self_, 2));
  EXPECT_TRUE(stand_ins_.consult(2, 0));
}

TEST_F(SupervisorTrial, PassesThroughTheBehavioursAndEndsWithTheTrial) {
  stand_ins_.tell_trial(1);
  ASSERT_TRUE(status_.await_ready(self_, 1)) << child_.err();
  std::set<scarab_BehaviourState> states;
  constexpr std::uint32_t kLast = 60;
  for (std::uint32_t tick = 0; tick < kLast; ++tick) {
    const auto behaviour = stand_ins_.consult(1, tick);
    ASSERT_TRUE(behaviour) << child_.err();
    states.insert(behaviour->state);
  }
  EXPECT_GE(states.size(), 3U);
  EXPECT_EQ(states.count(scarab_BEHAVIOUR_DONE), 0U);
  auto last = Supervisor::question_of(1, kLast);
  last.phase = scarab_PHASE_SUCCEEDED;
  stand_ins_.ask(last);
  const auto behaviour = stand_ins_.answers().await(1, kLast);
  ASSERT_TRUE(behaviour);
  EXPECT_EQ(behaviour->state, scarab_BEHAVIOUR_DONE);
  EXPECT_TRUE(status_.await(
      self_, [](const auto& report) { return report.lifecycle == scarab_LIFECYCLE_INACTIVE; }));
}

TEST_F(SupervisorTrial, WithoutJointFeedbackTheSupplyCurrentSwitches) {
  constexpr std::uint32_t kBlocked = 75, kLast = 110;
  stand_ins_.tell_trial(1);
  ASSERT_TRUE(status_.await_ready(self_, 1)) << child_.err();
  std::optional<std::uint32_t> mode_2_at;
  for (std::uint32_t tick = 0; tick < kLast && !mode_2_at; ++tick) {
    stand_ins_.ask(Supervisor::blind_question_of(1, tick, kBlocked));
    const auto behaviour = stand_ins_.answers().await(1, tick);
    ASSERT_TRUE(behaviour) << child_.err();
    EXPECT_EQ(behaviour->trigger, scarab_TRIGGER_SUPPLY_CURRENT) << tick;
    if (behaviour->state != scarab_BEHAVIOUR_MODE_2) continue;
    mode_2_at = tick;
    EXPECT_GT(behaviour->trigger_value, behaviour->trigger_threshold);
    EXPECT_THAT(behaviour->reason, HasSubstr("supply current"));
  }
  ASSERT_TRUE(mode_2_at) << "no switch";
  EXPECT_GT(*mode_2_at, kBlocked) << "switched before the current rose";
}

TEST_F(SupervisorTrial, WhereNothingTellsOfTheObstacleItSaysSo) {
  stand_ins_.tell_trial(1);
  ASSERT_TRUE(status_.await_ready(self_, 1)) << child_.err();
  auto question = Supervisor::blind_question_of(1, 0, 0);
  question.supply_current_source = scarab_SOURCE_ABSENT;
  stand_ins_.ask(question);
  const auto behaviour = stand_ins_.answers().await(1, 0);
  ASSERT_TRUE(behaviour) << child_.err();
  EXPECT_EQ(behaviour->trigger, scarab_TRIGGER_NONE);
  const auto report = status_.await_health(self_, scarab_HEALTH_DEGRADED);
  ASSERT_TRUE(report) << child_.err();
  EXPECT_THAT(report->message,
              AllOf(HasSubstr("no mode 2"), HasSubstr("front_angle, supply_current")));
  stand_ins_.tell_trial(2);  // and a robot that measures is none the worse for it
  ASSERT_TRUE(status_.await_ready(self_, 2)) << child_.err();
  const auto next = stand_ins_.consult(2, 0);
  ASSERT_TRUE(next) << child_.err();
  EXPECT_EQ(next->trigger, scarab_TRIGGER_FRONT_ANGLE);
  EXPECT_TRUE(status_.await_health(self_, scarab_HEALTH_OK));
}

}  // namespace
}  // namespace scarab::test
