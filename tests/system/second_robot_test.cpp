// Robots are data: another body walks with the same programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>

#include "common/config/robot_file.hpp"
#include "common/robot/joint_limits.hpp"
#include "tests/support/files.hpp"
#include "tests/support/status_watch.hpp"
#include "tests/system/stack.hpp"
#include "tests/system/trial_log.hpp"
#include "tests/system/walk.hpp"

namespace scarab::test {
namespace {

constexpr std::chrono::seconds kTrialLimit{60};
constexpr double kTickPeriod = 0.1;  // s, timing.control_period_s of the plant's file
constexpr const char* kRobot = "phantomx";

Arguments walk_trial(const std::string& strategy, const std::string& seed) {
  return {"--strategy", strategy, "--goal", "none",         "--height",
          "0",          "--seed", seed,     "--time-limit", "20"};
}

void expect_upright_on_its_feet(const Walk& walk) {
  EXPECT_LT(walk.tilt_most_rad, 0.1);
  EXPECT_GT(walk.height_least_m, 0.1) << "it stands at 0.12 m";
  for (std::size_t leg = 0; leg < robot::kLegCount; ++leg) {
    const double air = walk.air_share[leg];
    EXPECT_TRUE(air > 0.25 && air < 0.75)
        << robot::kLegNames[leg] << " was off the ground " << air << " of the time";
  }
}

/// That the gate clamped no more than `jumps` targets, for their speed, and refused nothing.
void expect_unclamped(const std::map<std::string, std::uint64_t>& counters, std::uint64_t jumps) {
  EXPECT_LE(counters.at("targets_clamped_window"), jumps);
  for (const auto& [name, count] : counters) {
    if (name == "targets_clamped_range" || name == "targets_clamped_torque" ||
        name.rfind("commands_refused", 0) == 0) {
      EXPECT_EQ(count, 0U) << name;
    }
  }
}

/// The network is warmed up walking backward. Forward turns the swing of every T-joint round, once,
/// when the change has come through the layers and the delay line: 13 ticks.
constexpr std::size_t kTurnTicks = 13;
constexpr std::uint64_t kTurnClamps = 6;

class SecondRobot : public testing::TestWithParam<const char*> {
 protected:
  /// The log of a walk in one process.
  std::filesystem::path simulated(const std::string& seed) const {
    auto log = directory_ / ("seed-" + seed + ".mcap");
    const auto sim = run(simulate(log, walk_trial(GetParam(), seed), kRobot), kTrialLimit);
    EXPECT_EQ(sim.exit_code, 0) << sim.out << sim.err;
    return log;
  }

  /// +1 for forward, -1 for backward.
  [[nodiscard]] static double direction() {
    return GetParam() == std::string("walk-forward") ? 1 : -1;
  }

  const robot::RobotModel robot_ =
      config::load_robot(source_file(std::string("config/robot/") + kRobot + ".yaml"));
  TemporaryDirectory directory_;
};

TEST_P(SecondRobot, WalksAlongItsHeadingUprightAndOnItsFeet) {
  for (const std::string seed : {"1", "2", "3"}) {
    SCOPED_TRACE("seed " + seed);
    const Walk walk = read_walk(simulated(seed));
    EXPECT_NEAR(walk.time_s, 20, 1e-9);
    EXPECT_GT(direction() * walk.ahead_m, 1.2) << "20 s at 0.06 m/s";
    EXPECT_LT(std::abs(walk.turned_rad), 0.5);
    EXPECT_LT(std::abs(walk.sideways_m), std::abs(walk.ahead_m));
    expect_upright_on_its_feet(walk);
  }
}

/// The first robot walks too; its object is put out of the way.
TEST_P(SecondRobot, IsNotTheOnlyOneThatWalks) {
  const auto plant = directory_ / "far.yaml";
  write_text(plant, "extends: " + source_file("config/plant/beetle.yaml").string() +
                        "\nobject: {start_distance_m: 5.0}\n");
  const auto log = directory_ / "beetle.mcap";
  Arguments command = simulate(log, walk_trial(GetParam(), "1"), "beetle");
  *std::next(std::find(command.begin(), command.end(), "--plant")) = plant;
  const auto sim = run(command, kTrialLimit);
  ASSERT_EQ(sim.exit_code, 0) << sim.out << sim.err;
  const Walk walk = read_walk(log);
  EXPECT_GT(direction() * walk.ahead_m, 1.5);
  EXPECT_LT(std::abs(walk.turned_rad), 0.6);
  EXPECT_LT(walk.tilt_most_rad, 0.15);
}

TEST_P(SecondRobot, IsToldNothingThatItsServosCannotDo) {
  const Walk walk = read_walk(simulated("1"));
  ASSERT_GE(walk.targets_rad.size(), 200U);
  for (std::size_t k = 0; k < walk.targets_rad.size(); ++k) {
    const auto& target = walk.targets_rad[k];
    EXPECT_EQ(robot::clipped_to_ranges(robot_, target), target) << "tick " << k;
    for (std::size_t slot = 0; slot < robot::kJointCount && k > kTurnTicks; ++slot) {
      EXPECT_LE(std::abs(target[slot] - walk.targets_rad[k - 1][slot]),
                robot_.joints[slot].velocity_max_rad_s * kTickPeriod)
          << robot::kJointNames[slot] << " at tick " << k;
    }
  }
}

TEST_P(SecondRobot, HasNoBackboneAnywhere) {
  const auto log = simulated("1");
  EXPECT_EQ(traces_of_joint(log, robot::kBackboneSlot), 0U);
  EXPECT_GT(traces_of_joint(log, 0), 0U) << "so traces can be found";
}

TEST_P(SecondRobot, WalksAsMuchToTheByteInRealProcesses) {
  Stack::Options options;
  options.robot = kRobot;
  Stack stack(directory_ / "stack", options);
  StatusWatch watch;
  auto experiment = stack.conduct(walk_trial(GetParam(), "1"));
  const auto code = experiment.wait(kTrialLimit);
  ASSERT_EQ(code, 0) << experiment.out() << experiment.err() << stack.errors();
  const auto plant = watch.await({"plant", 0}, [](const auto& report) {
    return report.counters.count("commands_accepted") != 0 &&
           report.counters.at("commands_accepted") >= 200;
  });
  ASSERT_TRUE(plant);
  expect_unclamped(plant->counters, direction() > 0 ? kTurnClamps : 0);
  ASSERT_TRUE(stack.stop()) << stack.errors();
  const auto result = compare(stack.log(), simulated("1"));
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

INSTANTIATE_TEST_SUITE_P(Directions, SecondRobot, testing::Values("walk-forward", "walk-backward"),
                         [](const auto& strategy) {
                           return std::string(strategy.index == 0 ? "Forward" : "Backward");
                         });

}  // namespace
}  // namespace scarab::test
