#include <gmock/gmock.h>

#include "tests/support/files.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

constexpr std::chrono::seconds kTrialLimit{60};

class Lockstep : public testing::Test {
 protected:
  /// Runs the main trial on a stack of its own; its log, or an empty path if it did not end.
  std::filesystem::path run_trial(const std::string& name) {
    Stack stack(directory_ / name);
    auto experiment = stack.conduct(main_trial());
    const auto code = experiment.wait(kTrialLimit);
    EXPECT_TRUE(code && *code <= 1) << experiment.out() << experiment.err() << stack.errors();
    EXPECT_TRUE(stack.stop()) << stack.errors();
    return code && *code <= 1 ? stack.log() : std::filesystem::path();
  }

  static void expect_equal(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto result = compare(a, b);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  }

  TemporaryDirectory directory_;
};

/// A process that keeps a core busy.
ChildProcess busy(const std::filesystem::path& output) {
  return {{"/bin/sh", "-c", "while :; do :; done"}, output};
}

TEST_F(Lockstep, SameTrialGivesTheSameBytesInEveryRunAndUnderLoadAndInOneProcess) {
  const auto first = run_trial("first");
  ASSERT_FALSE(first.empty());
  const auto trial = read_trial(first);
  EXPECT_GE(trial.ticks.size(), 150U);
  EXPECT_GE(trial.mode_changes, 2U);
  EXPECT_TRUE(contiguous_from_zero(trial.ticks));

  expect_equal(first, run_trial("second"));
  expect_equal(first, run_trial("third"));
  {
    const auto one_core = busy(directory_ / "busy-1");
    const auto other_core = busy(directory_ / "busy-2");
    expect_equal(first, run_trial("loaded"));
  }
  const auto in_process = directory_ / "sim.mcap";
  const auto sim = run(simulate(in_process), kTrialLimit);
  ASSERT_LE(sim.exit_code, 1) << sim.out << sim.err;
  expect_equal(first, in_process);
}

/// That nothing differs would mean little if nothing could.
TEST_F(Lockstep, ComparisonNoticesOneChangedByteOnEachTopic) {
  const auto original = directory_ / "sim.mcap";
  const auto sim = run(simulate(original), kTrialLimit);
  ASSERT_LE(sim.exit_code, 1) << sim.out << sim.err;
  expect_equal(original, original);
  for (const std::string topic :
       {"scarab/robot_state", "scarab/robot_sensors", "scarab/behaviour", "scarab/joint_command",
        "scarab/neural_activity", "scarab/world_state"}) {
    const auto changed = directory_ / "changed.mcap";
    constexpr std::uint32_t kSample = 77;
    constexpr std::size_t kOffset = 9;  // the second byte of the second number in most types
    copy_with_changed_byte(original, changed, topic, kSample, kOffset);
    const auto result = compare(original, changed);
    EXPECT_EQ(result.exit_code, 1) << topic;
    EXPECT_THAT(result.out + result.err, HasSubstr(topic));
  }
}

}  // namespace
}  // namespace scarab::test
