// The paper's task on the cores alone: what must come out of the physics, over perturbed trials.
#include <gtest/gtest.h>

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

TEST(Task, SoftPushingCarriesTheObjectOnTheFlat) {
  const Outcome soft = run("soft", 0, 5);
  EXPECT_EQ(soft.successes, 5);
  EXPECT_NEAR(soft.mean_time_s, 14.5, 2);  // of the prototype
}

TEST(Task, HardPushingAloneLosesTheObjectOnTheFlat) { EXPECT_LE(run("hard", 0, 5).successes, 2); }

TEST(Task, SoftThenHardPushingCrossesTenCentimetres) {
  EXPECT_GE(run("soft+hard", 0.10, 5).successes, 4);
}

TEST(Task, BehavioursFollowFromTheSensors) {
  ClosedLoop loop("soft+hard", testing::default_config(), trial(0.10, 1));
  loop.run();
  EXPECT_EQ(loop.states(),
            (std::vector<State>{State::kApproach, State::kClimb, State::kMode1, State::kMode2}));
}

}  // namespace
}  // namespace scarab::plant
