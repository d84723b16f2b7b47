#include "tests/system/random_kills.hpp"

#include <gmock/gmock.h>

#include <iostream>

#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/system/keeper.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/witness.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::chrono::seconds kTrialLimit{60};
constexpr unsigned kTrials = 4;
constexpr std::size_t kKillsPerTrial = 5;

class RandomKills : public testing::Test {
 protected:
  RandomKills() {
    const auto log = directory_ / "undisturbed.mcap";
    const auto sim = run(simulate(log), kTrialLimit);
    EXPECT_LE(sim.exit_code, 1) << sim.out << sim.err;
    undisturbed_ = Trajectory::read(log);
    last_tick_ = undisturbed_.of("scarab/robot_state").rbegin()->first.first;
  }

  /// One trial under these kills: all that was seen of it is as undisturbed, and all was seen.
  void run_trial(const std::string& name, const std::vector<Kill>& kills) {
    Witness witness;
    Stack::Options options;
    options.witness = true;
    Stack stack(directory_ / name, options);
    auto experiment = stack.conduct(main_trial());
    Keeper keeper(stack);
    for (const Kill& kill : kills) {
      const bool reached = eventually([&] {
        keeper.restart_due();
        return witness.tick() >= kill.tick;
      });
      ASSERT_TRUE(reached) << "stuck before tick " << kill.tick << "\n"
                           << experiment.out() << stack.errors();
      keeper.look_after(kill.delay);
      keeper.kill(kill.service);
      ASSERT_LT(witness.tick(), last_tick_) << "too late: the trial is over";
    }
    const bool ended = eventually(
        [&] {
          keeper.restart_due();
          witness.look();
          return !experiment.running();
        },
        kTrialLimit);
    ASSERT_TRUE(ended) << "the trial does not end\n" << experiment.out() << stack.errors();
    EXPECT_THAT(experiment.out(), HasSubstr("result: ")) << experiment.err() << stack.errors();
    keeper.restart_all();
    EXPECT_THAT(witness.look().contradictions(undisturbed_), IsEmpty());
    EXPECT_THAT(witness.look().gaps(undisturbed_), IsEmpty());
    // Only how the logger ends matters; the others would linger for readers that were killed.
    for (const auto* service : {"plant", "supervisor", "premotor"}) stack.kill(service);
    EXPECT_TRUE(stack.stop()) << stack.errors();
    expect_readable_logs(stack, keeper.kills_of("logger"));
  }

  /// A killed logger leaves a file that can be mended; what is in it is true.
  void expect_readable_logs(const Stack& stack, unsigned kills) {
    std::vector<std::filesystem::path> cut;
    std::vector<std::filesystem::path> logs;
    for (const auto& entry : std::filesystem::directory_iterator(stack.directory())) {
      if (entry.path().extension() == ".active") cut.push_back(entry.path());
      if (entry.path().extension() == ".mcap") logs.push_back(entry.path());
    }
    EXPECT_LE(cut.size(), kills);  // one that is killed before it has a file leaves none
    for (const auto& broken : cut) {
      logs.push_back(stack.directory() / ("mended-" + broken.stem().string()));
      const auto mending = run({program("scarab-log"), "recover", broken, logs.back()});
      ASSERT_EQ(mending.exit_code, 0) << broken << ": " << mending.err;
    }
    for (const auto& log : logs) {
      EXPECT_THAT(Trajectory::read(log).contradictions(undisturbed_), IsEmpty()) << log;
    }
  }

  TemporaryDirectory directory_;
  Trajectory undisturbed_;
  std::int64_t last_tick_ = 0;
};

/// 20 kills: 5 in each of 4 trials.
TEST_F(RandomKills, LeaveTheTrajectoryAsItWas) {
  const std::uint64_t seed = test_seed();
  std::cout << "SCARAB_TEST_SEED=" << seed << " repeats these kills\n";
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    const auto kills = random_kills(seed + trial, kKillsPerTrial, last_tick_);
    std::string plan = "seed " + std::to_string(seed) + ", trial " + std::to_string(trial) + ":";
    for (const Kill& kill : kills) {
      plan += " " + kill.service + " at tick " + std::to_string(kill.tick) + " + " +
              std::to_string(kill.delay.count()) + " us,";
    }
    SCOPED_TRACE(plan);
    run_trial("trial-" + std::to_string(trial), kills);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace scarab::test
