#include <csignal>

#include "common/runtime/status_publisher.hpp"
#include "tests/integration/operator/running_stack.hpp"

// scarab-operator at a running stack: what it prints is what holds then.
namespace scarab::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

Finished operate(const Arguments& words, const std::string& tag = test_tag()) {
  Arguments command = {program("scarab-operator"), "--tag", tag};
  command.insert(command.end(), words.begin(), words.end());
  return test::run(command);
}

class OperatorTool : public RunningStack {
 protected:
  /// The one line it prints; fails unless it succeeds.
  std::string told(const Arguments& words) {
    const Finished finished = operate(words);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_EQ(std::count(finished.out.begin(), finished.out.end(), '\n'), 1) << finished.out;
    return finished.out;
  }
};

TEST_F(OperatorTool, DrivesTheRobotByHand) {
  begin_trial();
  EXPECT_THAT(told({"mode", "forward", "--reason", "to the window"}),
              MatchesRegex("supervisor/0: manual: mode forward \\(trial 1, tick [0-9]+\\)\n"));
  const auto forward = await_behaviour([](const auto& b) { return b.mode == scarab_MODE_FORWARD; });
  ASSERT_TRUE(forward);
  EXPECT_STREQ(forward->reason, "operator: mode forward: to the window");

  EXPECT_THAT(told({"inputs", "1", "-1", "0.5", "-0.25"}), HasSubstr("inputs 1 -1 0.5 -0.25"));
  const auto by_hand = await_behaviour([](const auto& b) { return b.inputs[3] == -0.25; });
  ASSERT_TRUE(by_hand);
  EXPECT_EQ(by_hand->state, scarab_BEHAVIOUR_MANUAL);

  EXPECT_THAT(told({"strategy", "walk-backward"}), HasSubstr("automatic: strategy walk-backward"));
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.mode == scarab_MODE_BACKWARD; }));
}

TEST_F(OperatorTool, PausesStepsAndGoesOn) {
  begin_trial();
  const std::string paused = told({"pause"});
  EXPECT_THAT(paused, StartsWith("plant/0: paused by the operator (trial 1, tick "));
  const auto tick_of = [](const std::string& line) {
    return std::stoi(line.substr(line.rfind(' ') + 1));
  };
  const std::string stepped = told({"step", "3"});
  EXPECT_THAT(stepped, HasSubstr("paused by the operator"));
  EXPECT_EQ(tick_of(stepped), tick_of(paused) + 3);

  EXPECT_THAT(told({"mode", "boxing"}),
              HasSubstr("supervisor/0: 'mode' counts from the next tick (start or step); plant/0: "
                        "paused by the operator"));
  EXPECT_EQ(tick_of(told({"step"})), tick_of(paused) + 4);
  EXPECT_TRUE(eventually([&] {
    const auto& all = behaviours_.all();
    return all.back().mode == scarab_MODE_BOXING;
  })) << "it was waiting for that tick";
  EXPECT_THAT(told({"start"}), StartsWith("plant/0: the trial runs"));
}

TEST_F(OperatorTool, EmergencyStopHoldsUntilAReset) {
  begin_trial(1, "walk-forward");
  EXPECT_THAT(told({"estop", "--reason", "smoke"}),
              StartsWith("plant/0: safe stop: operator emergency stop: smoke (trial 1, tick "));
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.state == scarab_BEHAVIOUR_SAFE_STOP; }));
  EXPECT_THAT(told({"mode", "backward"}),
              StartsWith("supervisor/0: safe stop; after it manual: mode backward"));
  EXPECT_THAT(told({"reset"}), testing::AnyOf(HasSubstr("homing"), HasSubstr("the trial runs")));
  const auto after = await_behaviour([](const auto& b) { return b.mode != scarab_MODE_STOP; });
  ASSERT_TRUE(after);
  EXPECT_EQ(after->mode, scarab_MODE_BACKWARD) << "the last word counts once it is over";
}

TEST_F(OperatorTool, EmergencyStopNeedsNoTrialAndIsLatched) {
  EXPECT_EQ(told({"emergency-stop", "--reason", "smoke"}),
            "plant/0: safe stop: operator emergency stop: smoke (no trial yet)\n");
  begin_trial();
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.state == scarab_BEHAVIOUR_SAFE_STOP; }));
  EXPECT_THAT(told({"reset"}), StartsWith("plant/0: "));
}

TEST_F(OperatorTool, EmergencyStopNeedsNoSupervisor) {
  begin_trial();
  supervisor_.signal(SIGSTOP);
  EXPECT_THAT(told({"estop"}), HasSubstr("safe stop: operator emergency stop"));
  supervisor_.signal(SIGCONT);
}

TEST_F(OperatorTool, StopEndsTheTrial) {
  begin_trial();
  EXPECT_THAT(told({"stop", "--reason", "lunch"}),
              MatchesRegex("plant/0: no trial runs \\(trial 1, tick [0-9]+\\)\n"));
  EXPECT_TRUE(
      eventually([&] { return behaviours_.all().back().state == scarab_BEHAVIOUR_FAILED; }));
}

TEST_F(OperatorTool, RefusalIsAFailureWithTheReason) {
  begin_trial();
  const auto refused = operate({"strategy", "sofd"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err, HasSubstr("scarab-operator: supervisor/0: operator's word refused: "
                                     "unknown strategy 'sofd'; there are: boxing"));
}

TEST_F(OperatorTool, WithoutATrialNobodyIsDriven) {
  ASSERT_TRUE(status_.await({"supervisor", 0}, [](const auto&) { return true; }));
  const auto refused = operate({"mode", "forward"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("no trial runs"));
}

/// A tick master that listens and does nothing.
class DeafTickMaster {
 public:
  bool has_heard() {
    return eventually([this] { return !said_.all().empty(); });
  }

 private:
  bus::Participant participant_{test_options("plant")};
  bus::Writer<scarab_RobotState> states_{participant_, bus::kRobotState};
  Inbox<scarab_Operator> said_{participant_, bus::kOperator};
  runtime::StatusPublisher status_{participant_, {"plant", 0}};
};

TEST(OperatorAnswer, WhoDoesNotAcknowledgeIsNamed) {
  const DeafTickMaster deaf;
  const auto silent = operate({"estop"});
  EXPECT_EQ(silent.exit_code, 1);
  EXPECT_EQ(silent.err,
            "scarab-operator: THE EMERGENCY STOP DID NOT GET THROUGH: plant/0 has not acknowledged "
            "'estop' within 3 s\n");
}

TEST(OperatorAnswer, InterruptedNothingIsSure) {
  const TemporaryDirectory directory;
  DeafTickMaster deaf;
  ChildProcess tool({program("scarab-operator"), "--tag", test_tag(), "estop"}, directory / "tool");
  ASSERT_TRUE(deaf.has_heard());
  tool.signal(SIGINT);
  EXPECT_EQ(tool.wait(kPatience), 130);
  EXPECT_THAT(tool.err(), HasSubstr("interrupted: 'estop' may or may not have been carried out"));
}

TEST(OperatorAnswer, NobodyThereIsAFailure) {
  const TemporaryDirectory directory;
  const std::vector<std::string> words = {"pause", "estop", "automatic"};
  std::vector<ChildProcess> tools;
  tools.reserve(words.size());
  for (const auto& word : words) {
    tools.push_back(
        {{program("scarab-operator"), "--tag", test_tag(), word}, directory / word.c_str()});
  }
  for (auto& tool : tools) {
    EXPECT_EQ(tool.wait(kPatience), 1);
    EXPECT_THAT(tool.err(), HasSubstr("nobody listens on scarab/operator"));
    EXPECT_EQ(tool.err().find("DID NOT GET THROUGH") != std::string::npos, &tool == &tools[1])
        << "of the emergency stop alone";
    EXPECT_THAT(tool.err(), HasSubstr("domain 0 with tag " + test_tag()));
  }
}

TEST(OperatorUsage, BadWordsAreOneLine) {
  for (const Arguments& words :
       {Arguments{}, Arguments{"go"}, Arguments{"mode"}, Arguments{"mode", "fly"},
        Arguments{"inputs", "1", "0", "0"}, Arguments{"inputs", "1", "0", "0", "1.5"},
        Arguments{"inputs", "1", "0", "0", "nan"}, Arguments{"step", "0"}, Arguments{"step", "x"},
        Arguments{"strategy"}, Arguments{"strategy", std::string(64, 'x')},
        Arguments{"pause", "start"}}) {
    const auto bad = operate(words);
    EXPECT_EQ(bad.exit_code, 2) << bad.out;
    EXPECT_EQ(std::count(bad.err.begin(), bad.err.end(), '\n'), 1) << bad.err;
    EXPECT_THAT(bad.err, HasSubstr("--help"));
  }
}

TEST(OperatorUsage, EveryCommandHasHelpWithAnExample) {
  for (const char* name : {"start", "pause", "step", "stop", "estop", "emergency-stop", "reset",
                           "automatic", "strategy", "mode", "inputs"}) {
    const auto help = operate({name, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.out, HasSubstr("Example:\n  scarab-operator ")) << name;
  }
}

}  // namespace
}  // namespace scarab::test
