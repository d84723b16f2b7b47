#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>

#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::uint32_t kDomain = 97;
constexpr std::chrono::seconds kRunLimit{60};

/// The launcher with the real programs, as a person calls it.
class Launcher : public testing::Test {
 protected:
  /// The command line; a session of its own, so that Ctrl-C reaches all of it and nobody else.
  Arguments scarab(const Arguments& words) const {
    Arguments command = {"/usr/bin/setsid", source_file("deploy/scarab")};
    command.insert(command.end(), words.begin(), words.end());
    command.insert(command.end(), {"--domain", std::to_string(kDomain), "--bin",
                                   fs::path(program("x")).parent_path(), "--runs", runs_});
    return command;
  }
  Arguments scarab_run(const Arguments& trial) const {
    Arguments words = {"run", "--tag", test_tag()};
    words.insert(words.end(), trial.begin(), trial.end());
    return scarab(words);
  }
  /// The one run directory.
  fs::path run_directory() const { return fs::canonical(runs_ / "latest"); }
  /// Command lines of processes that have to do with this test's runs.
  std::vector<std::string> living() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const std::string line = read_text(entry.path() / "cmdline");
      if (line.find(runs_.string()) != std::string::npos) found.push_back(line);
    }
    return found;
  }
  static void expect_readable(const fs::path& log) {
    const auto info = run({program("scarab-log"), "info", log});
    EXPECT_EQ(info.exit_code, 0) << info.err;
  }

  TemporaryDirectory directory_;
  fs::path runs_ = directory_ / "runs";
};

/// Trials whose outcome needs no physics: the time limit is success for one, failure for the other.
const Arguments kSuccess = {"--goal", "none", "--time-limit", "3"};
const Arguments kFailure = {"--goal", "travel", "--distance", "10", "--time-limit", "1"};
const Arguments kEndless = {"--goal", "none", "--time-limit", "36000"};

TEST_F(Launcher, RunThatSucceedsLeavesAllItsFiles) {
  const auto result = run(scarab_run(kSuccess), kRunLimit);
  ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("result: success"));
  const auto directory = run_directory();
  for (const auto* name :
       {"trial.mcap", "results.csv", "figure7.svg", "figure7.png", "figure7.csv",
        "config/plant.yaml", "config/premotor.yaml", "config/supervisor.yaml", "config/stack.yaml",
        "logs/plant.log", "state/premotor-0.state", "state/supervisor-0.state"}) {
    EXPECT_TRUE(fs::is_regular_file(directory / name) && fs::file_size(directory / name) > 0)
        << name;
  }
  expect_readable(directory / "trial.mcap");
  const auto trial = read_trial(directory / "trial.mcap");
  EXPECT_TRUE(contiguous_from_zero(trial.ticks));
  EXPECT_EQ(trial.ticks.size(), 31U);  // 3 s at 10 Hz and the tick of the verdict
  EXPECT_THAT(living(), IsEmpty());
}

TEST_F(Launcher, RunThatFailsSaysSo) {
  const auto result = run(scarab_run(kFailure), kRunLimit);
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("result: failure"));
  expect_readable(run_directory() / "trial.mcap");
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
  const auto up = run(scarab({"up", "--tag", test_tag()}), kRunLimit);
  ASSERT_EQ(up.exit_code, 0) << up.out << up.err;
  EXPECT_EQ(run(scarab({"status"}), kRunLimit).exit_code, 0);
  for (int i = 0; i < 2; ++i) {
    const auto result = run(scarab({"run", "--goal", "none", "--time-limit", "1"}), kRunLimit);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  }
  const auto down = run(scarab({"down"}), kRunLimit);
  EXPECT_EQ(down.exit_code, 0) << down.out << down.err;
  EXPECT_THAT(living(), IsEmpty());
}

}  // namespace
}  // namespace scarab::test
