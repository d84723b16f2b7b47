#include "tests/integration/operator/pseudo_terminal.hpp"
#include "tests/integration/operator/running_stack.hpp"

// scarab-drive with a person at its terminal and a stack that runs.
namespace scarab::test {
namespace {

using testing::HasSubstr;

const std::string kUp = "\x1bOA";  // as xterm sends it to a program that asked for such keys

class DriveStack : public RunningStack {
 protected:
  static PseudoTerminal::Start drive(const Arguments& more = {}) {
    PseudoTerminal::Start start;
    start.command = {program("scarab-drive"), "--tag", test_tag(), "--strategies",
                     "soft,walk-forward"};
    start.command.insert(start.command.end(), more.begin(), more.end());
    return start;
  }
  /// The next thing said on scarab/operator after the first `count`.
  std::optional<scarab_Operator> said_after(std::size_t count) {
    if (!eventually([&] { return said_.all().size() > count; })) return std::nullopt;
    return said_.all()[count];
  }
  std::size_t said_so_far() { return said_.all().size(); }

  Inbox<scarab_Trial> told_{participant_, bus::kTrial};
};

TEST_F(DriveStack, StartsATrialAndDrivesItByHand) {
  PseudoTerminal terminal(drive({"--seed", "7"}));
  ASSERT_TRUE(terminal.shows("no trial yet")) << terminal.letters();
  ASSERT_TRUE(terminal.shows("premotor/0"));
  terminal.type("t");
  const auto trial = told_.await(1, 0);
  ASSERT_TRUE(trial) << terminal.letters();
  EXPECT_EQ(trial->goal, scarab_GOAL_NONE);
  EXPECT_STREQ(trial->strategy, "stand");
  EXPECT_EQ(trial->seed, 7U);
  EXPECT_EQ(trial->obstacle_height_m, 0);
  EXPECT_GE(trial->time_limit_s, 600);
  ASSERT_TRUE(terminal.shows("running")) << terminal.letters();

  terminal.type("f");
  const auto mode = said_after(0);
  ASSERT_TRUE(mode);
  EXPECT_EQ(mode->command, scarab_OPERATOR_MODE);
  EXPECT_EQ(mode->mode, scarab_MODE_FORWARD);
  EXPECT_EQ(mode->header.trial, 1U);
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.mode == scarab_MODE_FORWARD; }));
  EXPECT_TRUE(terminal.shows("behaviour manual mode forward")) << terminal.letters();

  terminal.type("3" + kUp + kUp);
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.inputs[2] == 0.2; }));
  EXPECT_TRUE(terminal.shows("I3 +0.20")) << terminal.letters();
}

TEST_F(DriveStack, SpaceStopsAndAResetAsksFirst) {
  begin_trial();
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows("running"));
  terminal.type(" ");
  const auto stop = said_after(0);
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->command, scarab_OPERATOR_EMERGENCY_STOP);
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.state == scarab_BEHAVIOUR_SAFE_STOP; }));
  EXPECT_TRUE(terminal.shows("SAFE STOP operator emergency stop")) << terminal.letters();

  terminal.type("r");
  EXPECT_TRUE(terminal.shows("Leave the safe stop?"));
  // Ctrl-L, with which the test looks, is no answer; n is a no.
  terminal.type("n");
  EXPECT_TRUE(terminal.shows("r reset"));
  EXPECT_EQ(said_so_far(), 1U);
  terminal.type("ry");
  const auto reset = said_after(1);
  ASSERT_TRUE(reset);
  EXPECT_EQ(reset->command, scarab_OPERATOR_RESET);
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.state == scarab_BEHAVIOUR_APPROACH; }));
}

TEST_F(DriveStack, FollowsAStrategyOfTheMenu) {
  begin_trial();
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows("running"));
  terminal.type("m");
  ASSERT_TRUE(terminal.shows("walk-forward"));
  terminal.type("\x1bOB\r");
  const auto strategy = said_after(0);
  ASSERT_TRUE(strategy);
  EXPECT_EQ(strategy->command, scarab_OPERATOR_STRATEGY);
  EXPECT_STREQ(strategy->strategy, "walk-forward");
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.mode == scarab_MODE_FORWARD; }));
}

TEST_F(DriveStack, PausesAndSteps) {
  begin_trial();
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows("running"));
  terminal.type("p");
  EXPECT_TRUE(terminal.shows("paused by the operator")) << terminal.letters();
  terminal.type("ng");
  for (const auto command : {scarab_OPERATOR_PAUSE, scarab_OPERATOR_STEP, scarab_OPERATOR_START}) {
    const auto count = static_cast<std::size_t>(command == scarab_OPERATOR_PAUSE  ? 0
                                                : command == scarab_OPERATOR_STEP ? 1
                                                                                  : 2);
    const auto said = said_after(count);
    ASSERT_TRUE(said);
    EXPECT_EQ(said->command, command);
  }
}

TEST_F(DriveStack, QuittingLeavesTheStackAsItIs) {
  begin_trial();
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows("running"));
  terminal.type("f");
  ASSERT_TRUE(await_behaviour([](const auto& b) { return b.mode == scarab_MODE_FORWARD; }));
  terminal.type("q");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_THAT(terminal.letters(), HasSubstr("thestackstaysasitis:trial1goeson"));
  EXPECT_EQ(said_so_far(), 1U) << "nothing was said on leaving";
  const auto still = await_behaviour([](const auto&) { return true; });
  ASSERT_TRUE(still);
  EXPECT_EQ(still->mode, scarab_MODE_FORWARD);
}

TEST_F(DriveStack, WithoutATrialOnlyTheEmergencyStopAndTheResetAreSaid) {
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows("plant/0"));
  terminal.type("fap");
  EXPECT_TRUE(terminal.shows("no trial runs; t starts one")) << terminal.letters();
  terminal.type(" ");
  const auto stop = said_after(0);
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->command, scarab_OPERATOR_EMERGENCY_STOP) << "the first thing said";
  EXPECT_TRUE(terminal.shows("SAFE STOP")) << terminal.letters();
}

TEST_F(DriveStack, StartsATrialByOption) {
  PseudoTerminal terminal(drive({"--trial", "--strategy", "walk-forward", "--height", "0.05"}));
  const auto trial = told_.await(1, 0);
  ASSERT_TRUE(trial) << terminal.letters();
  EXPECT_STREQ(trial->strategy, "walk-forward");
  EXPECT_EQ(trial->obstacle_height_m, 0.05);
  EXPECT_TRUE(await_behaviour([](const auto& b) { return b.mode == scarab_MODE_FORWARD; }));
}

}  // namespace
}  // namespace scarab::test
