#include <gmock/gmock.h>

#include "common/bus/clock.hpp"
#include "common/runtime/status_publisher.hpp"
#include "tests/integration/responder/stand_ins.hpp"
#include "tests/integration/supervisor/supervisor_questions.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/status_watch.hpp"

// What a person says on scarab/operator to a supervisor in the middle of a trial.
namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A participant that speaks on scarab/operator.
class Speaker {
 public:
  explicit Speaker(const std::string& name = "operator") : participant_(test_options(name)) {}

  /// Says it, stamped now; returns the stamp.
  std::int64_t say(scarab_Operator said) {
    said.header.stamp_ns = bus::now_ns();
    writer_.write(said);
    return said.header.stamp_ns;
  }
  bool is_heard_by_the_supervisor() {
    return eventually([this] {
      const auto readers = writer_.matched();
      return std::find(readers.begin(), readers.end(), bus::Peer{"supervisor", 0}) != readers.end();
    });
  }

 private:
  bus::Participant participant_;
  bus::Writer<scarab_Operator> writer_{participant_, bus::kOperator};
};

scarab_Operator word(std::uint32_t trial, scarab_OperatorCommand command) {
  scarab_Operator said{};
  said.header.trial = trial;
  said.command = command;
  return said;
}

scarab_Operator mode_word(std::uint32_t trial, scarab_Mode mode) {
  auto said = word(trial, scarab_OPERATOR_MODE);
  said.mode = mode;
  return said;
}

scarab_Operator strategy_word(std::uint32_t trial, const std::string& strategy) {
  auto said = word(trial, scarab_OPERATOR_STRATEGY);
  bus::assign(said.strategy, strategy);
  return said;
}

class SupervisorOperator : public testing::Test {
 protected:
  using Answer = std::optional<scarab_Behaviour>;

  void begin(std::uint32_t trial = 1) {
    trial_ = trial;
    tick_ = 0;
    stand_ins_.tell_trial(trial);
    ASSERT_TRUE(status_.await_ready(self_, trial)) << child_.err();
    ASSERT_TRUE(speaker_.is_heard_by_the_supervisor());
    ASSERT_TRUE(step());
  }
  Answer step(scarab_TrialPhase phase = scarab_PHASE_RUNNING) {
    auto question = Supervisor::question_of(trial_, tick_);
    question.phase = phase;
    stand_ins_.ask(question);
    return stand_ins_.answers().await(trial_, tick_++);
  }
  std::optional<StatusWatch::Report> acknowledged(
      std::int64_t stamp_ns, std::chrono::milliseconds limit = std::chrono::milliseconds(50)) {
    return status_.await(
        self_,
        [&](const auto& report) {
          const auto counter = report.counters.find(runtime::kOperatorStamp);
          return counter != report.counters.end() &&
                 counter->second == static_cast<std::uint64_t>(stamp_ns);
        },
        limit);
  }
  /// Ticks until the word is acknowledged: it counts from one of these on. The report, and the
  /// answer to one tick more.
  std::pair<std::optional<StatusWatch::Report>, Answer> carried_out(std::int64_t stamp_ns) {
    std::optional<StatusWatch::Report> report;
    for (int i = 0; i < 100 && !report; ++i) {
      if (!step()) break;
      report = acknowledged(stamp_ns);
    }
    EXPECT_TRUE(report) << child_.err();
    return {report, step()};
  }

  const bus::Peer self_{"supervisor", 0};
  TemporaryDirectory run_dir_;
  StatusWatch status_;
  StandIns<Supervisor> stand_ins_;
  Speaker speaker_;
  std::uint32_t trial_ = 0;
  std::uint32_t tick_ = 0;
  ChildProcess child_ = start({"supervisor", Supervisor::kExpect, run_dir_.path(), 0, {}});
};

TEST_F(SupervisorOperator, HoldsAModeUntilItIsAutomaticAgain) {
  begin();
  const auto [report, answer] = carried_out(speaker_.say(mode_word(1, scarab_MODE_BOXING)));
  ASSERT_TRUE(report && answer);
  EXPECT_EQ(report->message, "manual: mode boxing");
  EXPECT_EQ(report->health, scarab_HEALTH_OK);
  EXPECT_EQ(answer->state, scarab_BEHAVIOUR_MANUAL);
  EXPECT_EQ(answer->mode, scarab_MODE_BOXING);
  EXPECT_EQ(answer->inputs[0], -1);
  EXPECT_THAT(answer->reason, HasSubstr("operator: mode boxing"));

  const auto [back, after] = carried_out(speaker_.say(word(1, scarab_OPERATOR_AUTOMATIC)));
  ASSERT_TRUE(back && after);
  EXPECT_THAT(back->message, HasSubstr("automatic"));
  EXPECT_NE(after->state, scarab_BEHAVIOUR_MANUAL);
  EXPECT_EQ(after->mode, scarab_MODE_BACKWARD);
}

TEST_F(SupervisorOperator, HoldsInputs) {
  begin();
  auto said = word(1, scarab_OPERATOR_INPUTS);
  const std::array<double, 4> inputs = {0.5, -0.25, 1, -1};
  std::copy(inputs.begin(), inputs.end(), std::begin(said.inputs));
  const auto [report, answer] = carried_out(speaker_.say(said));
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->inputs, testing::ElementsAreArray(inputs));
  EXPECT_EQ(answer->state, scarab_BEHAVIOUR_MANUAL);
}

TEST_F(SupervisorOperator, FollowsAnotherStrategy) {
  begin();
  const auto [report, answer] = carried_out(speaker_.say(strategy_word(1, "walk-forward")));
  ASSERT_TRUE(report && answer);
  EXPECT_EQ(report->message, "automatic: strategy walk-forward");
  EXPECT_EQ(answer->mode, scarab_MODE_FORWARD);
}

TEST_F(SupervisorOperator, RefusesWhatItCannotDoInWordsAndGoesOn) {
  begin();
  auto [report, answer] = carried_out(speaker_.say(strategy_word(1, "sofd")));
  ASSERT_TRUE(report && answer);
  EXPECT_EQ(report->health, scarab_HEALTH_DEGRADED);
  EXPECT_THAT(report->message, AllOf(HasSubstr("refused"), HasSubstr("unknown strategy 'sofd'"),
                                     HasSubstr("soft+hard")));
  EXPECT_EQ(answer->mode, scarab_MODE_BACKWARD);

  auto said = word(1, scarab_OPERATOR_INPUTS);
  said.inputs[2] = 1.5;
  std::tie(report, answer) = carried_out(speaker_.say(said));
  ASSERT_TRUE(report && answer);
  EXPECT_EQ(report->health, scarab_HEALTH_DEGRADED);
  EXPECT_THAT(report->message, HasSubstr("I3 is 1.5, not in [-1, 1]"));
  EXPECT_NE(answer->state, scarab_BEHAVIOUR_MANUAL);

  std::tie(report, answer) = carried_out(speaker_.say(mode_word(1, scarab_MODE_STOP)));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->health, scarab_HEALTH_OK) << "the next good word is none the worse for it";
}

TEST_F(SupervisorOperator, KilledItTakesUpTheHand) {
  begin();
  const auto stamp_ns = speaker_.say(mode_word(1, scarab_MODE_FORWARD));
  ASSERT_TRUE(carried_out(stamp_ns).second);
  child_.kill();
  auto fresh = start({"supervisor", Supervisor::kExpect, run_dir_.path(), 0, {}});
  ASSERT_TRUE(status_.await_ready(self_, 1, fresh.pid())) << fresh.err();
  const auto answer = step();
  ASSERT_TRUE(answer) << fresh.err();
  EXPECT_EQ(answer->state, scarab_BEHAVIOUR_MANUAL);
  EXPECT_EQ(answer->mode, scarab_MODE_FORWARD);
  EXPECT_TRUE(acknowledged(stamp_ns, kPatience)) << "whoever waits for it is answered";
}

TEST_F(SupervisorOperator, RestartedItHearsNoOldWordAgain) {
  begin();
  Speaker other("drive");
  ASSERT_TRUE(other.is_heard_by_the_supervisor());
  ASSERT_TRUE(carried_out(other.say(mode_word(1, scarab_MODE_FORWARD))).second);
  ASSERT_TRUE(carried_out(speaker_.say(mode_word(1, scarab_MODE_BOXING))).second);
  child_.kill();
  auto fresh = start({"supervisor", Supervisor::kExpect, run_dir_.path(), 0, {}});
  ASSERT_TRUE(status_.await_ready(self_, 1, fresh.pid())) << fresh.err();
  ASSERT_TRUE(other.is_heard_by_the_supervisor());  // its last word is handed over again
  for (int i = 0; i < 20; ++i) {
    const auto answer = step();
    ASSERT_TRUE(answer) << fresh.err();
    EXPECT_EQ(answer->mode, scarab_MODE_BOXING);
  }
}

TEST_F(SupervisorOperator, NewTrialBeginsAutomatic) {
  begin(1);
  ASSERT_TRUE(carried_out(speaker_.say(mode_word(1, scarab_MODE_FORWARD))).second);
  begin(2);
  const auto answer = step();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->state, scarab_BEHAVIOUR_APPROACH);
  EXPECT_EQ(answer->mode, scarab_MODE_BACKWARD);
}

TEST_F(SupervisorOperator, WordForAnotherTrialIsForNobody) {
  begin(2);
  speaker_.say(mode_word(1, scarab_MODE_FORWARD));
  const auto [report, answer] = carried_out(speaker_.say(strategy_word(2, "soft")));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->state, scarab_BEHAVIOUR_APPROACH);
}

TEST_F(SupervisorOperator, WithoutATrialItRefuses) {
  ASSERT_TRUE(speaker_.is_heard_by_the_supervisor()) << child_.err();
  const auto report = acknowledged(speaker_.say(mode_word(0, scarab_MODE_FORWARD)), kPatience);
  ASSERT_TRUE(report) << child_.err();
  EXPECT_EQ(report->health, scarab_HEALTH_DEGRADED);
  EXPECT_THAT(report->message, HasSubstr("no trial runs"));
  begin();
  EXPECT_EQ(step()->state, scarab_BEHAVIOUR_APPROACH);
}

TEST_F(SupervisorOperator, SafeStopAndHomingComeFirst) {
  begin();
  ASSERT_TRUE(carried_out(speaker_.say(mode_word(1, scarab_MODE_FORWARD))).second);
  for (const auto phase : {scarab_PHASE_SAFE_STOP, scarab_PHASE_HOMING}) {
    const auto answer = step(phase);
    ASSERT_TRUE(answer) << child_.err();
    EXPECT_EQ(answer->state, scarab_BEHAVIOUR_SAFE_STOP);
    EXPECT_EQ(answer->mode, scarab_MODE_STOP);
  }
  const auto answer = step();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->mode, scarab_MODE_FORWARD);
}

TEST_F(SupervisorOperator, CommandsOfTheTickMasterAreNotItsOwn) {
  begin();
  const auto not_mine = speaker_.say(word(1, scarab_OPERATOR_EMERGENCY_STOP));
  ASSERT_TRUE(carried_out(speaker_.say(mode_word(1, scarab_MODE_FORWARD))).second);
  EXPECT_FALSE(acknowledged(not_mine));
}

TEST_F(SupervisorOperator, WordInAPauseCountsFromTheNextTick) {
  begin();
  const auto stamp_ns = speaker_.say(mode_word(1, scarab_MODE_FORWARD));
  // No tick comes: nothing is acknowledged, for nothing has changed yet.
  EXPECT_FALSE(acknowledged(stamp_ns, std::chrono::milliseconds(300)));
  const auto answer = step();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->mode, scarab_MODE_FORWARD);
  EXPECT_TRUE(acknowledged(stamp_ns, kPatience));
}

}  // namespace
}  // namespace scarab::test
