#include <gmock/gmock.h>

#include <atomic>
#include <csignal>
#include <sstream>
#include <thread>
#include <vector>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/files.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/view.hpp"

namespace scarab::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::chrono::seconds kLimit{60};

/// Four short trials that have little in common.
constexpr const char* kTrials =
    R"({"index": 10, "strategy": "soft+hard", "goal": "across", "height_m": 0.1, "distance_m": 1.46, "time_limit_s": 4, "seed": 1000001, "perturb_position_m": 0.02, "perturb_yaw_rad": 0.05, "perturb_friction": 0.1, "perturb_cpg_phase": true, "friction_scale": 1, "object_mass_kg": 0, "object_diameter_m": 0}
{"index": 11, "strategy": "boxing", "goal": "travel", "height_m": 0, "distance_m": 0.05, "time_limit_s": 5, "seed": 2, "perturb_position_m": 0, "perturb_yaw_rad": 0, "perturb_friction": 0, "perturb_cpg_phase": false, "friction_scale": 0.75, "object_mass_kg": 2.5, "object_diameter_m": 0.2}
{"index": 12, "strategy": "stationary+hard", "goal": "none", "height_m": 0.06, "distance_m": 1, "time_limit_s": 3, "seed": 18446744073709551615, "perturb_position_m": 0.01, "perturb_yaw_rad": 0.1, "perturb_friction": 0.25, "perturb_cpg_phase": true, "friction_scale": 1.25, "object_mass_kg": 1, "object_diameter_m": 0.14}
{"strategy": "walk-forward", "goal": "walk", "height_m": 0, "distance_m": 0.2, "time_limit_s": 5, "seed": 7, "perturb_position_m": 0.02, "perturb_yaw_rad": 3.1, "perturb_friction": 0.1, "perturb_cpg_phase": true, "friction_scale": 1, "object_mass_kg": 0, "object_diameter_m": 0}
)";

/// A first trial of a second, then one that is not to end.
constexpr const char* kEndless =
    R"({"index": 1, "strategy": "soft", "goal": "none", "height_m": 0, "distance_m": 1, "time_limit_s": 1, "seed": 1, "perturb_position_m": 0, "perturb_yaw_rad": 0, "perturb_friction": 0, "perturb_cpg_phase": true, "friction_scale": 1, "object_mass_kg": 0, "object_diameter_m": 0}
{"index": 2, "strategy": "stand", "goal": "none", "height_m": 0, "distance_m": 1, "time_limit_s": 36000, "seed": 1, "perturb_position_m": 0, "perturb_yaw_rad": 0, "perturb_friction": 0, "perturb_cpg_phase": true, "friction_scale": 1, "object_mass_kg": 0, "object_diameter_m": 0}
)";

/// Keeps every core busy as long as it lives.
class Load {
 public:
  Load() {
    for (unsigned i = 0; i < 2 * std::thread::hardware_concurrency(); ++i) {
      threads_.emplace_back([this] {
        while (!over_) {
        }
      });
    }
  }
  ~Load() {
    over_ = true;
    for (auto& thread : threads_) thread.join();
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::atomic<bool> over_{false};
  std::vector<std::thread> threads_;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Numbers of the trials in a log, in their order.
std::vector<std::uint32_t> trials_in(const std::filesystem::path& log) {
  std::vector<std::uint32_t> numbers;
  mcap::Reader(log).for_each(
      [&](const mcap::Channel&, const mcap::Message& message) {
        const auto* data = reinterpret_cast<const std::byte*>(message.data.data());
        numbers.push_back(bus::decode<scarab_Trial>({data, message.data.size()})->header.trial);
      },
      {bus::kTrial.name});
  return numbers;
}

class Worker : public testing::Test {
 protected:
  Worker() {
    write_text(trials_, kTrials);
    write_text(endless_, kEndless);
  }
  /// In this test's one process of cores, without a bus.
  [[nodiscard]] ChildProcess simulation(const std::filesystem::path& input) const {
    return {simulate(sim_log_, {"--worker"}), directory_ / "sim", input};
  }
  /// What a worker has written, once it has come to its end.
  static std::string rows_of(ChildProcess& worker) {
    EXPECT_EQ(worker.wait(kLimit), 0) << worker.output();
    return worker.out();
  }
  static bool has_begun_the_endless(ChildProcess& worker) {
    return eventually([&] { return lines_of(worker.out()).size() == 1; });
  }

  TemporaryDirectory directory_;
  const std::filesystem::path trials_ = directory_ / "trials.jsonl";
  const std::filesystem::path endless_ = directory_ / "endless.jsonl";
  const std::filesystem::path sim_log_ = directory_ / "sim.mcap";
};

TEST_F(Worker, RowsAndSamplesAreTheSameInOneProcessAndOnAStack) {
  auto sim = simulation(trials_);
  const auto rows = rows_of(sim);
  EXPECT_THAT(lines_of(rows), ElementsAre(HasSubstr(R"("index": 10, )"), HasSubstr("2.5"),
                                          HasSubstr("18446744073709551615"), HasSubstr("walk")));
  Stack stack(directory_ / "stack");
  auto worker = stack.conduct({"--worker"}, trials_);
  EXPECT_EQ(rows_of(worker), rows) << stack.errors();
  stack.stop();
  EXPECT_THAT(trials_in(sim_log_), ElementsAre(1, 2, 3, 4));
  const auto result = compare(sim_log_, stack.log());
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST_F(Worker, RowsAreTheSameUnderLoadAndOnAStackThatHasRunTrials) {
  auto sim = simulation(trials_);
  const auto rows = rows_of(sim);
  Stack stack(directory_ / "stack");
  const Load load;
  for (int i = 0; i < 2; ++i) {
    auto worker = stack.conduct({"--worker"}, trials_);
    EXPECT_EQ(rows_of(worker), rows) << stack.errors();
  }
}

TEST_F(Worker, RowsAreTheSameThoughServicesCrash) {
  std::string text = kEndless;
  text.replace(text.find("36000"), 5, "100");
  write_text(directory_ / "long", text);
  auto sim = simulation(directory_ / "long");
  const auto rows = rows_of(sim);
  Stack stack(directory_ / "stack");
  View view;
  auto worker = stack.conduct({"--worker"}, directory_ / "long");
  constexpr std::int64_t kInTheSecond = 20;  // the first trial ends before
  ASSERT_TRUE(view.await_tick(kInTheSecond)) << worker.output() << stack.errors();
  for (const auto* name : {"supervisor", "premotor"}) {
    stack.kill(name);
    stack.restart(name);
  }
  EXPECT_EQ(rows_of(worker), rows) << stack.errors();
}

TEST_F(Worker, ADeadPlantIsAnErrorAndNoResult) {
  Stack stack(directory_ / "stack");
  auto worker = stack.conduct({"--worker"}, endless_);
  ASSERT_TRUE(has_begun_the_endless(worker)) << worker.output() << stack.errors();
  stack.kill("plant");
  EXPECT_EQ(worker.wait(kLimit), 1);
  const auto rows = lines_of(worker.out());
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1], R"({"index": 2, "error": "plant/0 is gone"})");
}

TEST_F(Worker, ATrialThatTheStackRefusesIsAnErrorOfBoth) {
  std::string text = lines_of(kTrials)[0] + "\n";
  text.replace(text.find("soft+hard"), 9, "no-such");
  write_text(directory_ / "refused", text);
  auto sim = simulation(directory_ / "refused");
  EXPECT_EQ(sim.wait(kLimit), 1);
  EXPECT_THAT(sim.out(), HasSubstr(R"({"index": 10, "error": "unknown strategy 'no-such')"));
  Stack stack(directory_ / "stack");
  auto worker = stack.conduct({"--worker"}, directory_ / "refused");
  EXPECT_EQ(worker.wait(kLimit), 1);
  EXPECT_THAT(worker.out(), HasSubstr(R"({"index": 10, "error": )"));
  EXPECT_THAT(worker.out(), HasSubstr("unknown strategy 'no-such'"));
}

TEST_F(Worker, ASignalEndsItWithoutARowOfTheTrialUnderWay) {
  const auto expect_interrupted = [](ChildProcess worker, int number) {
    ASSERT_TRUE(has_begun_the_endless(worker)) << worker.output();
    worker.signal(number);
    EXPECT_EQ(worker.wait(std::chrono::seconds(5)), 130) << worker.output();
    EXPECT_EQ(lines_of(worker.out()).size(), 1U) << worker.out();
  };
  expect_interrupted(simulation(endless_), SIGINT);
  EXPECT_TRUE(mcap::Reader(sim_log_).closed());
  Stack stack(directory_ / "stack");
  expect_interrupted(stack.conduct({"--worker"}, endless_), SIGTERM);
}

TEST_F(Worker, TakesNoOptionsOfASeries) {
  for (const Arguments& option : {Arguments{"--trials", "2"}, Arguments{"--strategy", "soft"},
                                  Arguments{"--results", "rows.csv"}, Arguments{"--quiet"}}) {
    Arguments words = {"--worker"};
    words.insert(words.end(), option.begin(), option.end());
    for (auto command : {simulate(sim_log_, words), Arguments{program("scarab-experiment")}}) {
      if (command.size() == 1) command.insert(command.end(), words.begin(), words.end());
      const auto result = run(command, kLimit);
      EXPECT_EQ(result.exit_code, 2) << option[0];
      EXPECT_THAT(result.err, HasSubstr(option[0] + " excludes --worker"));
      EXPECT_EQ(result.out, "");
    }
  }
  EXPECT_FALSE(std::filesystem::exists(sim_log_));
}

}  // namespace
}  // namespace scarab::test
