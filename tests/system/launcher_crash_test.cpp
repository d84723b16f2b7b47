#include <csignal>

#include "tests/support/eventually.hpp"
#include "tests/system/launcher_rig.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

using Clock = std::chrono::steady_clock;

/// What becomes of trials, and of the stack, when a process of it is killed.
class LauncherCrash : public Launcher, public testing::WithParamInterface<std::string> {
 protected:
  /// Kills the plant of the stack in a directory; how long it takes `trial` to say that it failed.
  static std::chrono::milliseconds time_to_notice(ChildProcess& trial, const fs::path& stack) {
    const pid_t plant = pid_of(stack, "plant");
    const auto killed = Clock::now();
    ::kill(plant, SIGKILL);
    EXPECT_TRUE(eventually([&] {
      return trial.out().find("result: failure") != std::string::npos;
    })) << trial.output();
    return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - killed);
  }
  static void expect_failure_by_the_plant(ChildProcess& trial) {
    EXPECT_EQ(trial.wait(kRunLimit), 1) << trial.output();
    EXPECT_THAT(trial.out(), HasSubstr("plant was killed (signal 9)"));
  }
  [[nodiscard]] std::string pace() const { return "--" + GetParam(); }
};

TEST_P(LauncherCrash, PlantKilledInARunFailsTheTrialWithinTwoSeconds) {
  View view(kDomain);
  ChildProcess trial(scarab_run(kEndless + Arguments{pace(), "--trials", "2"}), directory_ / "run");
  ASSERT_TRUE(view.await_tick(10)) << trial.output();
  EXPECT_LT(time_to_notice(trial, run_directory()), std::chrono::seconds(2));
  expect_failure_by_the_plant(trial);
  EXPECT_THAT(read_text(run_directory() / "results.csv"), HasSubstr("plant was killed (signal 9)"));
  EXPECT_THAT(trial.out(), HasSubstr("the series ends here: 1 trials were not run"));
  EXPECT_THAT(living(), testing::IsEmpty());
}

TEST_P(LauncherCrash, PlantKilledOnAStackThatIsUpIsThereAgainForTheNextTrial) {
  up({pace()});
  const auto stack = run_directory();
  View view(kDomain);
  ChildProcess trial(scarab(Arguments{"run", "--no-figure"} + kEndless), directory_ / "run");
  ASSERT_TRUE(view.await_tick(10)) << trial.output();
  EXPECT_LT(time_to_notice(trial, stack), std::chrono::seconds(2));
  expect_failure_by_the_plant(trial);
  const auto next = run(scarab(Arguments{"run", "--no-figure"} + kSuccess), kRunLimit);
  EXPECT_EQ(next.exit_code, 0) << next.out << next.err;
  EXPECT_THAT(read_text(stack / "pids" / "plant.crashes"), HasSubstr("\"restarts\": 1"));
}

TEST_P(LauncherCrash, PremotorKilledIsRestartedAndTheRunTellsOfIt) {
  View view(kDomain);
  // In real time a spare bridges the gap: a tick that was missed is over.
  ChildProcess trial(scarab_run({"--goal", "none", "--time-limit", "6", pace(), "--replicas",
                                 GetParam() == "realtime" ? "premotor=2" : "premotor=1"}),
                     directory_ / "run");
  ASSERT_TRUE(view.await_tick(10)) << trial.output();
  ::kill(pid_of(run_directory(), "premotor"), SIGKILL);
  EXPECT_EQ(trial.wait(kRunLimit), 0) << trial.output();
  EXPECT_THAT(trial.err(), HasSubstr("premotor was killed (signal 9); restart 1 follows"));
  EXPECT_THAT(trial.out(), Not(HasSubstr("safe stop")));
}

INSTANTIATE_TEST_SUITE_P(InBothPaces, LauncherCrash, testing::Values("lockstep", "realtime"),
                         [](const auto& pace) { return pace.param; });

}  // namespace
}  // namespace scarab::test
