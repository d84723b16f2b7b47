#include <gmock/gmock.h>

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

}  // namespace
}  // namespace scarab::test
