#include <gmock/gmock.h>

#include <random>

#include "tests/support/files.hpp"
#include "tests/support/status_watch.hpp"
#include "tests/system/random_kills.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::chrono::seconds kTrialLimit{60};

/// A trial that is disturbed, to be compared with one that is not (the in-process one: equal to
/// that of the processes by the lockstep test).
class Crash : public testing::Test {
 protected:
  Crash() {
    const auto sim = run(simulate(undisturbed_), kTrialLimit);
    EXPECT_LE(sim.exit_code, 1) << sim.out << sim.err;
    last_tick_ = read_trial(undisturbed_).ticks.back();
  }
  /// Until the trial has gone that far, from 0 to 1, and is still under way.
  bool await_part(double part) {
    return view_.await_tick(static_cast<std::int64_t>(part * static_cast<double>(last_tick_))) &&
           view_.tick() < last_tick_;
  }
  /// Lets the trial end, and the stack.
  static void finish(Stack& stack, ChildProcess& experiment) {
    const auto code = experiment.wait(kTrialLimit);
    ASSERT_TRUE(code) << "the trial does not end\n" << experiment.out() << stack.errors();
    EXPECT_THAT(experiment.out(), HasSubstr("result: ")) << experiment.err();
    stack.stop();
  }
  void expect_as_undisturbed(const Stack& stack) const {
    const auto result = compare(undisturbed_, stack.log());
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err << stack.errors();
  }

  TemporaryDirectory directory_;
  const std::filesystem::path undisturbed_ = directory_ / "undisturbed.mcap";
  std::int64_t last_tick_ = 0;
  View view_;
  StatusWatch status_;
};

TEST_F(Crash, KilledAndRestartedServicesLeaveTheTrialAsItWas) {
  Stack stack(directory_ / "stack");
  auto experiment = stack.conduct(main_trial());
  const std::pair<double, const char*> kills[] = {{0.01, "premotor"}, {0.1, "supervisor"},
                                                  {0.3, "premotor"},  {0.31, "supervisor"},
                                                  {0.6, "premotor"},  {0.9, "supervisor"}};
  for (const auto& [part, name] : kills) {
    ASSERT_TRUE(await_part(part)) << experiment.out() << stack.errors();
    stack.kill(name);
    stack.restart(name);
  }
  finish(stack, experiment);
  EXPECT_THAT(experiment.out(), Not(HasSubstr("has not answered"))) << stack.errors();
  expect_as_undisturbed(stack);
}

TEST_F(Crash, BothAtOnce) {
  Stack stack(directory_ / "stack");
  auto experiment = stack.conduct(main_trial());
  ASSERT_TRUE(await_part(0.2)) << experiment.out() << stack.errors();
  stack.kill("premotor");
  stack.kill("supervisor");
  stack.restart("premotor");
  stack.restart("supervisor");
  finish(stack, experiment);
  expect_as_undisturbed(stack);
}

class CrashOfReplica : public Crash, public testing::WithParamInterface<const char*> {
 protected:
  Stack::Options options() const {
    Stack::Options options;
    options.replicas = {{GetParam(), 2}};
    return options;
  }
};

/// Nobody restarts the killed one: without the other the trial would end after 10 s.
TEST_P(CrashOfReplica, TheOtherGoesOnWithoutAPause) {
  const std::uint64_t seed = test_seed();
  std::mt19937_64 generator(seed);
  for (const std::uint32_t instance : {0U, 1U}) {
    const double part = std::uniform_real_distribution<double>(0.05, 0.8)(generator);
    SCOPED_TRACE("SCARAB_TEST_SEED=" + std::to_string(seed) + ": " + GetParam() + "/" +
                 std::to_string(instance) + " killed after " + std::to_string(part));
    Stack stack(directory_ / ("stack-" + std::to_string(instance)), options());
    View view;
    auto experiment = stack.conduct(main_trial());
    ASSERT_TRUE(view.await_tick(static_cast<std::int64_t>(part * static_cast<double>(last_tick_))));
    stack.kill(GetParam(), instance);
    ASSERT_LT(view.tick(), last_tick_) << "too late: the trial is over";
    finish(stack, experiment);
    // A pause of 1 s would have been reported.
    EXPECT_THAT(stack.service("plant").err(), Not(HasSubstr("has not answered")));
    expect_as_undisturbed(stack);
  }
}

TEST_P(CrashOfReplica, OneThatIsRestartedTakesPartAgain) {
  Stack stack(directory_ / "stack", options());
  auto experiment = stack.conduct(main_trial());
  for (const std::uint32_t instance : {0U, 1U}) {  // in the end neither is the one of the start
    ASSERT_TRUE(await_part(0.2 + 0.4 * instance)) << experiment.out() << stack.errors();
    stack.kill(GetParam(), instance);
    stack.restart(GetParam(), instance);
    const bus::Peer peer{GetParam(), instance};
    ASSERT_TRUE(status_.await_ready(peer, 1, stack.service(GetParam(), instance).pid()));
  }
  finish(stack, experiment);
  expect_as_undisturbed(stack);
}

INSTANTIATE_TEST_SUITE_P(Services, CrashOfReplica, testing::Values("premotor", "supervisor"),
                         [](const auto& service) { return service.param; });

TEST_F(Crash, KillOfThePlantFailsTheTrialSoon) {
  Stack stack(directory_ / "stack");
  auto experiment = stack.conduct(main_trial());
  ASSERT_TRUE(await_part(0.1)) << experiment.out() << stack.errors();
  const auto killed_at = std::chrono::steady_clock::now();
  stack.kill("plant");
  ASSERT_TRUE(eventually([&] { return experiment.out().find("result: ") != std::string::npos; }))
      << experiment.out() << stack.errors();
  const std::chrono::duration<double> told_after = std::chrono::steady_clock::now() - killed_at;
  EXPECT_LT(told_after.count(), 2.0);
  EXPECT_THAT(experiment.out(), AllOf(HasSubstr("result: failure"), HasSubstr("plant/0 is gone")));
  EXPECT_EQ(experiment.wait(kTrialLimit), 1) << experiment.out();
}

}  // namespace
}  // namespace scarab::test
