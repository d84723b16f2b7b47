// The paper's task on the cores alone: what must come out of the physics, over perturbed trials.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/plant/closed_loop.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using supervisor::State;
using testing::ClosedLoop;

struct Outcome {
  int successes = 0;
  double mean_time_s = 0;  ///< of the successes
};

TrialSpec trial(double obstacle_height_m, std::uint64_t seed) {
  TrialSpec out;
  out.goal = obstacle_height_m > 0 ? Goal::kAcross : Goal::kTravel;
  out.goal_distance_m = 1.46;
  out.obstacle_height_m = obstacle_height_m;
  out.seed = seed;
  out.perturb_position_m = 0.02;
  out.perturb_yaw_rad = 0.0524;
  out.perturb_friction = 0.10;
  return out;
}

Outcome run(const std::string& strategy, double obstacle_height_m, std::uint64_t trials) {
  Outcome out;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    ClosedLoop loop(strategy, testing::default_config(), trial(obstacle_height_m, seed));
    loop.run();
    const WorldTruth end = loop.plant().truth();
    if (end.verdict != Verdict::kSuccess) continue;
    ++out.successes;
    out.mean_time_s += end.verdict_time_s;
  }
  if (out.successes > 0) out.mean_time_s /= out.successes;
  return out;
}

/// Yaw of the trunk, rad.
double heading(const WorldTruth& truth) {
  const auto [w, x, y, z] = truth.trunk.orientation_wxyz;
  return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

/// Largest turn over 3 m of walking, from start to end, in so many trials.
double turn_rad(const std::string& strategy, std::uint64_t trials) {
  double most = 0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    TrialSpec walk = trial(0, seed);
    walk.goal = Goal::kWalk;
    walk.goal_distance_m = 3;
    ClosedLoop loop(strategy, testing::default_config(), walk);
    const double before = heading(loop.plant().truth());
    loop.run();
    const WorldTruth end = loop.plant().truth();
    EXPECT_EQ(end.verdict, Verdict::kSuccess) << end.verdict_reason;
    most = std::max(most, std::abs(heading(end) - before));
  }
  return most;
}

TEST(Task, SoftPushingIsTheFastestOnTheFlat) {
  const Outcome soft = run("soft", 0, 5);
  EXPECT_EQ(soft.successes, 5);
  for (const char* slower : {"boxing", "stationary"}) {
    const Outcome other = run(slower, 0, 5);
    EXPECT_GE(other.successes, 4) << slower;
    EXPECT_GT(other.mean_time_s, soft.mean_time_s) << slower;
  }
}

TEST(Task, WalkingKeepsItsHeading) {
  constexpr double kBound = 0.26;  // 15 deg; without the motor neurons' biases 0.47 backward
  EXPECT_LT(turn_rad("walk-forward", 3), kBound);
  EXPECT_LT(turn_rad("walk-backward", 3), kBound);
}

TEST(Task, HardPushingAloneLosesTheObjectOnTheFlat) { EXPECT_LE(run("hard", 0, 5).successes, 2); }

TEST(Task, SoftThenHardPushingCrossesFourteenCentimetres) {
  EXPECT_GE(run("soft+hard", 0.14, 5).successes, 4);
}

TEST(Task, NoModeAloneCrossesWhatCombinationsDo) {
  EXPECT_GE(run("stationary+hard", 0.10, 5).successes, 3);
  for (const char* alone : {"soft", "boxing", "stationary"}) {
    EXPECT_LE(run(alone, 0.10, 2).successes, 1) << alone;
  }
}

TEST(Task, BehavioursFollowFromTheSensors) {
  ClosedLoop loop("soft+hard", testing::default_config(), trial(0.10, 1));
  loop.run();
  EXPECT_EQ(loop.states(),
            (std::vector<State>{State::kApproach, State::kClimb, State::kMode1, State::kMode2}));
}

}  // namespace
}  // namespace scarab::plant
