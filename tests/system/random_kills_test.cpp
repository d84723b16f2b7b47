#include "tests/system/random_kills.hpp"

#include <gmock/gmock.h>

#include <iostream>

#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/support/test_bus.hpp"
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

/// The main trial on a stack of its own, with services that are killed.
class DisturbedTrial {
 public:
  DisturbedTrial(const std::filesystem::path& directory, std::int64_t last_tick)
      : last_tick_(last_tick), stack_(directory, with_witness()) {}

  /// False: the trial did not get so far, or was over already.
  bool strike(const Kill& kill) {
    if (!await([&] { return witness_.tick() >= kill.tick; })) return false;
    keeper_.look_after(kill.delay);
    if (!await([&] { return witness_.caught_up(); })) return false;
    const std::int64_t before = witness_.tick();
    keeper_.kill(kill.service);
    died_.push_back({kill.service, before - 1, witness_.tick()});
    return witness_.tick() < last_tick_;
  }

  bool await_end() {
    const bool ended = await([&] { return witness_.look(), !experiment_.running(); }, kTrialLimit);
    keeper_.restart_all();
    return ended;
  }

  /// What was not seen of `whole`. An answer is excused whose sender was killed at that moment: the
  /// plant may have it, and go on, and the witness not.
  std::vector<std::string> missing(const Trajectory& whole) {
    std::vector<std::string> names;
    for (const auto& gap : witness_.look().gaps(whole)) {
      if (!excused(gap)) names.push_back(gap.topic + ", tick " + std::to_string(gap.tick));
    }
    return names;
  }

  /// Only how the logger ends matters; the others would linger for readers that were killed.
  bool close_log() {
    for (const auto* service : {"plant", "supervisor", "premotor"}) stack_.kill(service);
    return stack_.stop();
  }

  const Trajectory& seen() { return witness_.look(); }
  [[nodiscard]] unsigned kills_of(const std::string& service) const {
    return keeper_.kills_of(service);
  }
  [[nodiscard]] const std::filesystem::path& directory() const { return stack_.directory(); }
  [[nodiscard]] std::string result() const { return experiment_.out(); }
  [[nodiscard]] std::string words() const {
    const auto status = run({program("scarab-status"), "--tag", test_tag()});
    return experiment_.out() + experiment_.err() + stack_.errors() + status.out;
  }

 private:
  struct Death {
    std::string service;
    std::int64_t first_tick;
    std::int64_t last_tick;
  };

  static Stack::Options with_witness() {
    Stack::Options options;
    options.witness = true;
    return options;
  }

  template <class Condition>
  bool await(Condition&& condition, std::chrono::milliseconds limit = kPatience) {
    return eventually([&] { return keeper_.restart_due(), condition(); }, limit);
  }

  [[nodiscard]] bool excused(const Trajectory::Gap& gap) const {
    return std::any_of(died_.begin(), died_.end(), [&](const Death& death) {
      return answers(death.service, gap.topic) && gap.tick >= death.first_tick &&
             gap.tick <= death.last_tick;
    });
  }
  static bool answers(const std::string& service, const std::string& topic) {
    if (service == "supervisor") return topic == bus::kBehaviour.name;
    return service == "premotor" &&
           (topic == bus::kJointCommand.name || topic == bus::kNeuralActivity.name);
  }

  std::int64_t last_tick_;
  Witness witness_;
  Stack stack_;
  ChildProcess experiment_ = stack_.conduct(main_trial());
  Keeper keeper_{stack_};
  std::vector<Death> died_;
};

class RandomKills : public testing::Test {
 protected:
  RandomKills() {
    const auto log = directory_ / "undisturbed.mcap";
    const auto sim = run(simulate(log), kTrialLimit);
    EXPECT_LE(sim.exit_code, 1) << sim.out << sim.err;
    undisturbed_ = Trajectory::read(log);
    last_tick_ = undisturbed_.of(bus::kRobotState.name).rbegin()->first.first;
  }

  /// All that was seen of the trial is as undisturbed, and all was seen.
  void expect_undisturbed(const std::filesystem::path& directory, const std::vector<Kill>& kills) {
    DisturbedTrial trial(directory, last_tick_);
    for (const Kill& kill : kills) {
      ASSERT_TRUE(trial.strike(kill)) << "not at tick " << kill.tick << "\n" << trial.words();
    }
    ASSERT_TRUE(trial.await_end()) << "the trial does not end\n" << trial.words();
    EXPECT_THAT(trial.result(), HasSubstr("result: ")) << trial.words();
    EXPECT_THAT(trial.seen().contradictions(undisturbed_), IsEmpty());
    EXPECT_THAT(trial.missing(undisturbed_), IsEmpty());
    EXPECT_TRUE(trial.close_log()) << trial.words();
    expect_true_logs(trial);
  }

  /// A killed logger leaves a file that can be mended; what is in it is true.
  void expect_true_logs(const DisturbedTrial& trial) {
    std::vector<std::filesystem::path> cut;
    std::vector<std::filesystem::path> logs;
    for (const auto& entry : std::filesystem::directory_iterator(trial.directory())) {
      if (entry.path().extension() == ".active") cut.push_back(entry.path());
      if (entry.path().extension() == ".mcap") logs.push_back(entry.path());
    }
    EXPECT_LE(cut.size(), trial.kills_of("logger"));  // killed before it had a file: leaves none
    for (const auto& broken : cut) {
      logs.push_back(trial.directory() / ("mended-" + broken.stem().string()));
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

std::string in_words(const std::vector<Kill>& kills) {
  std::string text;
  for (const Kill& kill : kills) {
    text += kill.service + " at tick " + std::to_string(kill.tick) + " + " +
            std::to_string(kill.delay.count()) + " us, ";
  }
  return text;
}

/// 20 kills: 5 in each of 4 trials.
TEST_F(RandomKills, LeaveTheTrajectoryAsItWas) {
  const std::uint64_t seed = test_seed();
  std::cout << "SCARAB_TEST_SEED=" << seed << " repeats these kills\n";
  for (unsigned trial = 0; trial < kTrials; ++trial) {
    const auto kills = random_kills(seed + trial, kKillsPerTrial, last_tick_);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", trial " + std::to_string(trial) + ": " +
                 in_words(kills));
    expect_undisturbed(directory_ / ("trial-" + std::to_string(trial)), kills);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace scarab::test
