#include <gmock/gmock.h>

#include <iostream>
#include <random>

#include "tests/support/files.hpp"
#include "tests/support/status_watch.hpp"
#include "tests/system/keeper.hpp"
#include "tests/system/random_kills.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trajectory.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

using testing::IsEmpty;

constexpr std::chrono::seconds kTrialLimit{40};

/// The first seconds of the main trial.
Arguments short_trial(const std::string& seconds) {
  Arguments trial = main_trial();
  trial.insert(trial.end(), {"--time-limit", seconds});
  return trial;
}

/// A short trial by the wall clock.
class RealTimeStack : public testing::Test {
 protected:
  using Report = StatusWatch::Report;

  RealTimeStack() : generator_(seed_) {
    std::cout << "SCARAB_TEST_SEED=" << seed_ << " repeats these moments\n";
  }

  static Stack::Options options(const std::map<std::string, unsigned>& replicas = {}) {
    Stack::Options options;
    options.replicas = replicas;
    options.real_time = true;
    return options;
  }

  /// Kills a service once the trial has come to `tick` and a random part of the next second has
  /// gone; it is restarted as the launcher does.
  void kill_after(std::int64_t tick, Keeper& keeper, const std::string& service,
                  std::uint32_t instance = 0) {
    ASSERT_TRUE(eventually([&] { return keeper.restart_due(), view_.tick() >= tick; })) << service;
    const auto delay = std::uniform_int_distribution<int>(0, 1000)(generator_);
    keeper.look_after(std::chrono::milliseconds(delay));
    keeper.kill(service, instance);
    std::cout << service << "/" << instance << " killed at tick " << view_.tick() << "\n";
  }

  /// Until the trial is over; what the plant says of it.
  std::optional<Report> finish(Stack& stack, Keeper& keeper, ChildProcess& experiment) {
    const bool ended =
        eventually([&] { return keeper.restart_due(), !experiment.running(); }, kTrialLimit);
    EXPECT_TRUE(ended) << experiment.out() << stack.errors();
    const auto report = status_.await({"plant", 0}, [&](const Report& plant) {
      return plant.lifecycle == scarab_LIFECYCLE_INACTIVE && plant.header.trial == 1;
    });
    EXPECT_TRUE(stack.stop()) << stack.errors();
    return ended ? report : std::nullopt;
  }

  std::uint64_t seed_ = test_seed();
  std::mt19937_64 generator_;
  TemporaryDirectory directory_;
  View view_;
  StatusWatch status_;
};

TEST_F(RealTimeStack, SameBytesAsInLockstepIfEveryCommandIsInTime) {
  const auto wanted = directory_ / "lockstep.mcap";
  ASSERT_LE(run(simulate(wanted, short_trial("5"))).exit_code, 1);
  const auto lockstep = Trajectory::read(wanted);
  // A command that comes late is applied late: no fault, but another trajectory. A loaded machine
  // has several goes.
  bool in_time = false;
  for (int go = 0; go < 4 && !in_time; ++go) {
    Stack stack(directory_ / std::to_string(go), options());
    Keeper keeper(stack);
    auto experiment = stack.conduct(short_trial("5"));
    const auto plant = finish(stack, keeper, experiment);
    ASSERT_TRUE(plant);
    in_time = plant->counters.at("commands_late") == 0;
    if (!in_time) continue;
    const auto seen = Trajectory::read(stack.log());
    EXPECT_THAT(seen.paceless().contradictions(lockstep), IsEmpty());
    EXPECT_THAT(seen.gaps(lockstep), IsEmpty());
    EXPECT_FALSE(seen.contradictions(lockstep).empty()) << "the samples do not say real time";
  }
  EXPECT_TRUE(in_time);
}

TEST_F(RealTimeStack, ReplicaLetsNoTickBeMissedWhicheverIsKilled) {
  Stack stack(directory_ / "stack", options({{"premotor", 2}}));
  Keeper keeper(stack);
  auto experiment = stack.conduct(short_trial("6"));
  kill_after(5, keeper, "premotor", 0);
  const auto ready_again = [&] {
    keeper.restart_due();
    const auto report = status_.await(
        {"premotor", 0}, [](const auto&) { return true; }, std::chrono::milliseconds(1));
    return report && report->ready_trial == 1 && keeper.all_up() &&
           report->process_id == static_cast<std::uint32_t>(stack.service("premotor").pid());
  };
  ASSERT_TRUE(eventually(ready_again)) << stack.errors();
  kill_after(view_.tick() + 3, keeper, "premotor", 1);
  const auto plant = finish(stack, keeper, experiment);
  ASSERT_TRUE(plant);
  // Each tick had a valid answer before the next began. (The counter is that of the beginning of
  // the last tick.)
  EXPECT_EQ(plant->counters.at("commands_accepted"), plant->header.tick);
  EXPECT_EQ(plant->counters.at("safe_stops"), 0U) << plant->message;
  std::cout << "longest command age " << plant->histograms.at("command_age").max_s() << " s, late "
            << plant->counters.at("commands_late") << "\n";
}

/// Premotor and supervisor have no replica here: while one is away ticks go unanswered, but it is
/// back, with its state, before the gate loses patience.
TEST_F(RealTimeStack, RestartedServiceIsBackBeforeTheSafeStop) {
  Stack stack(directory_ / "stack", options());
  Keeper keeper(stack);
  auto experiment = stack.conduct(short_trial("6"));
  kill_after(5, keeper, "premotor");
  kill_after(28, keeper, "supervisor");
  const auto plant = finish(stack, keeper, experiment);
  ASSERT_TRUE(plant);
  EXPECT_EQ(plant->counters.at("safe_stops"), 0U) << plant->message << stack.errors();
  std::cout << "ticks answered " << plant->counters.at("commands_accepted") << " of "
            << plant->header.tick << "\n";
}

}  // namespace
}  // namespace scarab::test
