#include <unistd.h>

#include <csignal>

#include "tests/support/test_bus.hpp"
#include "tests/system/launcher_rig.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

void expect_readable(const fs::path& log) {
  const auto info = run({program("scarab-log"), "info", log});
  EXPECT_EQ(info.exit_code, 0) << info.err;
}

TEST_F(Launcher, RunThatSucceedsLeavesAllItsFiles) {
  const auto result =
      run(scarab(Arguments{"run", "--tag", test_tag()} + kSuccess), kRunLimit);  // with its figure
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("result: success"));
  const auto directory = run_directory();
  for (const auto* name : {"trial.mcap", "results.csv", "figure7.svg", "figure7.png", "figure7.csv",
                           "config/plant.yaml", "config/premotor.yaml", "config/supervisor.yaml",
                           "config/stack.yaml", "config/run.yaml", "logs/plant.log",
                           "state/premotor-0.state", "state/supervisor-0.state"}) {
    EXPECT_TRUE(fs::is_regular_file(directory / name) && fs::file_size(directory / name) > 0)
        << name;
  }
  expect_readable(directory / "trial.mcap");
  const auto trial = read_trial(directory / "trial.mcap");
  EXPECT_TRUE(contiguous_from_zero(trial.ticks));
  EXPECT_EQ(trial.ticks.size(), 31U);  // 3 s at 10 Hz and the tick of the verdict
  EXPECT_THAT(living(), IsEmpty());
  const auto latest = run(tool({"log", "info", "latest"}));
  EXPECT_EQ(latest.exit_code, 0) << latest.err;
  EXPECT_THAT(latest.out, HasSubstr("scarab/neural_activity"));
}

TEST_F(Launcher, RunWithoutALoggerWaitsForNone) {
  const auto result = run(scarab_run(kSuccess + Arguments{"--no-log"}), kRunLimit);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_FALSE(fs::exists(run_directory() / "logs" / "logger.log"));
  EXPECT_FALSE(fs::exists(run_directory() / "trial.mcap"));
}

TEST_F(Launcher, RunThatFailsSaysSo) {
  const auto result = run(scarab_run(kFailure), kRunLimit);
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("result: failure"));
  expect_readable(run_directory() / "trial.mcap");
  EXPECT_THAT(living(), IsEmpty());
}

TEST_F(Launcher, ServiceThatCannotGoOnEndsTheStartAtOnce) {
  const std::string file = directory_ / "logger.yaml";
  write_text(file, "extends: " + source_file("config/logger/default.yaml").string() +
                       "\nfree_disk_mib: 1073741824\n");
  const auto begin = std::chrono::steady_clock::now();
  const auto result =
      run(scarab_run(kSuccess + Arguments{"--config", "logger=" + file}), kRunLimit);
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_THAT(result.err, HasSubstr("logger/0: disk too full to record"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(15)) << "not 30 s";
  EXPECT_THAT(living(), IsEmpty());
}

TEST_F(Launcher, UnknownStrategyFailsAndNamesTheKnownOnes) {
  const auto result = run(scarab_run({"--strategy", "sofd"}), kRunLimit);
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.out + result.err, HasSubstr("soft+hard"));
  EXPECT_THAT(living(), IsEmpty());
}

TEST_F(Launcher, BadUsageStartsNothing) {
  for (const Arguments& bad :
       {Arguments{"--height", "-1"}, {"--no-such-option"}, {"--goal", "across", "--height", "0"}}) {
    const auto result = run(scarab_run(bad), kRunLimit);
    EXPECT_EQ(result.exit_code, 2) << bad.front() << result.err;
    EXPECT_FALSE(fs::exists(runs_)) << bad.front();
  }
}

TEST_F(Launcher, InterruptLeavesNoProcessAndAClosedLog) {
  View view(kDomain);
  ChildProcess child(scarab_run(kEndless), directory_ / "run");
  ASSERT_TRUE(view.await_tick(100)) << child.out() << child.err();
  ASSERT_FALSE(living().empty());
  ::kill(-child.pid(), SIGINT);  // the whole foreground, as the terminal does
  EXPECT_EQ(child.wait(kRunLimit), 130) << child.out() << child.err();
  EXPECT_THAT(living(), IsEmpty());
  const auto log = run_directory() / "trial.mcap";
  ASSERT_TRUE(fs::exists(log));
  EXPECT_FALSE(fs::exists(log.string() + ".active"));
  expect_readable(log);
  const auto trial = read_trial(log);
  EXPECT_TRUE(contiguous_from_zero(trial.ticks));
  EXPECT_GE(trial.ticks.size(), 100U);
}

TEST_F(Launcher, StackOfItsOwnServesTrialAfterTrialUntilDown) {
  up({"--lockstep"});
  EXPECT_EQ(run(scarab({"status"}), kRunLimit).exit_code, 0);
  for (int i = 0; i < 2; ++i) {
    const auto result =
        run(scarab({"run", "--no-figure", "--goal", "none", "--time-limit", "1"}), kRunLimit);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  }
  const auto down = run(scarab({"down"}), kRunLimit);
  EXPECT_EQ(down.exit_code, 0) << down.out << down.err;
  EXPECT_THAT(living(), IsEmpty());
}

TEST_F(Launcher, RealTimeTakesItsTimeAndLockstepDoesNot) {
  const auto trial_s = [&](const Arguments& command) {
    View view(kDomain);
    ChildProcess child(command, directory_ / "run");
    EXPECT_TRUE(view.await_tick(0)) << child.output();
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(child.wait(kRunLimit), 0) << child.output();
    EXPECT_TRUE(view.await_tick(30));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  EXPECT_GE(trial_s(scarab_run(kSuccess + Arguments{"--realtime"})), 2.9);
  const std::string paced = read_text(run_directory() / "results.csv");
  EXPECT_THAT(paced, testing::ContainsRegex(",(0[.]9[0-9]|1[.]0[0-9]),")) << "x real time";
}

TEST_F(Launcher, UpGoesByTheWallClockAndRunFollowsIt) {
  up();
  const auto result =
      run(scarab({"run", "--no-figure", "--goal", "none", "--time-limit", "2"}), kRunLimit);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("in real time"));
  EXPECT_THAT(read_text(run_directory() / "results.csv"),
              testing::ContainsRegex(",(0[.]9[0-9]|1[.]0[0-9]),"));
  const auto contradicting = run(scarab({"run", "--lockstep"}), kRunLimit);
  EXPECT_EQ(contradicting.exit_code, 2);
  EXPECT_THAT(contradicting.err, HasSubstr("the stack that is up goes in real time"));
}

TEST_F(Launcher, SpareTakesPartWithNoChangeOfTheTrial) {
  const auto alone = run(scarab_run(kSuccess), kRunLimit);
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  const auto log_alone = run_directory() / "trial.mcap";
  const auto both = run(scarab_run(kSuccess + Arguments{"--replicas", "premotor=2"}), kRunLimit);
  ASSERT_EQ(both.exit_code, 0) << both.err;
  EXPECT_TRUE(fs::exists(run_directory() / "logs" / "premotor-1.log"));
  const auto result = run({program("scarab-log"), "diff", log_alone, run_directory() / "trial.mcap",
                           "--topic", "scarab/robot_state"});
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST_F(Launcher, OperatorSpeaksToTheStackThatIsUp) {
  up({"--lockstep"});
  View view(kDomain);
  ChildProcess trial(scarab(Arguments{"run", "--no-figure"} + kEndless), directory_ / "run");
  ASSERT_TRUE(view.await_tick(50)) << trial.output();
  for (const std::string verb : {"pause", "step", "start", "estop", "reset", "stop"}) {
    const auto said = run(scarab({verb, "--reason", "a test"}), kRunLimit);
    EXPECT_EQ(said.exit_code, 0) << verb << said.out << said.err;
  }
  EXPECT_EQ(trial.wait(kRunLimit), 1) << trial.output();
  EXPECT_THAT(trial.out(), HasSubstr("operator stop: a test"));
  EXPECT_EQ(run(scarab({"status"}), kRunLimit).exit_code, 0) << "the stack stays up";
}

TEST_F(Launcher, CompletesWhatTheToolsThemselvesOffer) {
  const auto candidates = [&](const std::string& line) {
    return run(tool({"__complete", "line", line})).out;
  };
  EXPECT_THAT(candidates("scarab topic "), HasSubstr("echo\t"));
  EXPECT_THAT(candidates("scarab log "), HasSubstr("recover\t"));
  EXPECT_THAT(candidates("scarab log export --"), HasSubstr("--topic\t"));
  EXPECT_THAT(candidates("scarab operator mode "), HasSubstr("backward\n"));
  EXPECT_THAT(candidates("scarab run --strategy "), HasSubstr("soft+hard\n"));
  EXPECT_THAT(candidates("scarab config "), HasSubstr("check\t"));
  EXPECT_THAT(candidates("scarab drive --"), HasSubstr("--trial\t"));
}

TEST_F(Launcher, CompletesTopicsAndFieldsOfTheSystemThatRunsAndOfItsLog) {
  up({"--lockstep"});
  ASSERT_EQ(run(scarab(Arguments{"run", "--no-figure"} + kSuccess), kRunLimit).exit_code, 0);
  const auto candidates = [&](const std::string& line) {
    return run(tool({"__complete", "line", line})).out;
  };
  EXPECT_THAT(candidates("scarab topic echo scarab/b"), "scarab/behaviour\n");
  EXPECT_THAT(candidates("scarab topic echo scarab/behaviour --field bs_t"), "bs_threshold_rad\n");
  EXPECT_THAT(candidates("scarab topic pub x --type scarab::B"), "scarab::Behaviour\n");
  ASSERT_EQ(run(scarab({"down"}), kRunLimit).exit_code, 0);
  EXPECT_THAT(candidates("scarab log cat latest --topic scarab/b"), "scarab/behaviour\n");
  EXPECT_THAT(candidates("scarab log cat latest --topic scarab/behaviour --field bs_t"),
              "bs_threshold_rad\n");
}

}  // namespace
}  // namespace scarab::test
