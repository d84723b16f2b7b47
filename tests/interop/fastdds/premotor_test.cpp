/// A premotor controller on another vendor's DDS in the place of ours.
#include "tests/interop/bystander.hpp"
#include "tests/interop/fastdds/fixture.hpp"
#include "tests/support/inbox.hpp"
#include "tests/system/trial_log.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class FastDdsPremotor : public FastDdsTest {
 protected:
  [[nodiscard]] Stack::Options without_premotor() const {
    Stack::Options options = on_this_domain();
    options.others = {"premotor"};
    return options;
  }

  /// The main trial on a stack that is up; it has to succeed.
  static void expect_success(ChildProcess experiment, const Stack& stack) {
    EXPECT_EQ(experiment.wait(kTrialLimit), 0)
        << experiment.output() << stack.errors()
        << read_text(stack.directory() / "fastdds-premotor.err");
  }

  /// The same trial with our own premotor controller.
  std::filesystem::path run_with_ours() {
    Stack stack(directory_ / "ours", on_this_domain());
    expect_success(stack.conduct(main_trial()), stack);
    EXPECT_TRUE(stack.stop()) << stack.errors();
    return stack.log();
  }

  static void expect_equal(const std::filesystem::path& a, const std::filesystem::path& b) {
    EXPECT_THAT(read_trial(a).ticks, testing::SizeIs(testing::Ge(150U)));
    const Finished result = run({program("scarab-log"), "diff", a, b});
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    for (const char* topic : {"joint_command", "robot_state", "neural_activity"}) {
      EXPECT_THAT(result.out, HasSubstr(std::string("scarab/") + topic + ": "));
    }
  }
};

/// The libraries that a process has loaded.
std::string loaded_by(const ChildProcess& child) {
  return read_text("/proc/" + std::to_string(child.pid()) + "/maps");
}

TEST_F(FastDdsPremotor, DrivesTheRobotThroughAWholeTrialToTheSameBytes) {
  Stack stack(directory_ / "theirs", without_premotor());
  const auto premotor = start_premotor(stack);
  expect_success(stack.conduct(main_trial()), stack);
  EXPECT_THAT(loaded_by(*premotor), HasSubstr("libfastrtps"));
  EXPECT_THAT(loaded_by(*premotor), Not(HasSubstr("libddsc")));
  EXPECT_EQ(premotor->stop(), 0) << premotor->output();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  expect_equal(run_with_ours(), stack.log());
}

TEST_F(FastDdsPremotor, KilledInTheMiddleItGoesOnWhereItWas) {
  Stack stack(directory_ / "theirs", without_premotor());
  auto premotor = start_premotor(stack);
  Bystander bystander(claim_);
  Inbox<scarab_RobotState> states(bystander.participant(), bus::kRobotState);
  auto experiment = stack.conduct(main_trial());
  constexpr std::uint32_t kTick = 60;
  ASSERT_TRUE(eventually([&] {
    const auto& all = states.all();
    return !all.empty() && all.back().header.tick >= kTick;
  })) << stack.errors();
  premotor->kill();
  EXPECT_LT(states.all().back().header.tick, 150U) << "the trial was over before the kill";
  premotor = start_premotor(stack);
  expect_success(std::move(experiment), stack);
  EXPECT_EQ(premotor->stop(), 0) << premotor->output();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  expect_equal(run_with_ours(), stack.log());
}

}  // namespace
}  // namespace scarab::test
