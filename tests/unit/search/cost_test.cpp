#include "tools/search/cost.hpp"

#include <gtest/gtest.h>

namespace scarab::search {
namespace {

Scenario wall(Wanted wanted = Wanted::kSuccess) {
  Scenario scenario;
  scenario.goal = Goal::kAcross;
  scenario.height_m = 0.1;
  scenario.time_limit_s = 60;
  scenario.wanted = wanted;
  return scenario;
}

Measure success(double time_s) {
  Measure measure;
  measure.success = true;
  measure.time_s = time_s;
  measure.progress = 1;
  measure.lift = 1;
  return measure;
}

Measure failure(double progress, double lift) {
  Measure measure;
  measure.time_s = 60;
  measure.progress = progress;
  measure.lift = lift;
  return measure;
}

TEST(Cost, OfASuccessIsTheShareOfTheTimeLimit) {
  EXPECT_DOUBLE_EQ(trial_cost(wall(), success(15)), 0.25);
  EXPECT_LT(trial_cost(wall(), success(15)), trial_cost(wall(), success(16)));
}

TEST(Cost, OfAnyFailureIsAboveThatOfAnySuccess) {
  EXPECT_LE(trial_cost(wall(), success(60)), 1);
  EXPECT_GE(trial_cost(wall(), failure(1, 1)), 1);
  EXPECT_DOUBLE_EQ(trial_cost(wall(), failure(0, 0)), 2);
}

TEST(Cost, OfAFailureFallsWithTheWayMadeAndWithTheRiseOfTheObject) {
  double before = 3;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double cost = trial_cost(wall(), failure(share, share));
    EXPECT_LT(cost, before);
    before = cost;
  }
  EXPECT_LT(trial_cost(wall(), failure(0.8, 0.5)), trial_cost(wall(), failure(0.8, 0.1)));
  EXPECT_LT(trial_cost(wall(), failure(0.8, 0.5)), trial_cost(wall(), failure(0.5, 0.5)));
}

TEST(Cost, KnowsNoRiseWhereThereIsNothingToCross) {
  Scenario flat = wall();
  flat.goal = Goal::kTravel;
  EXPECT_DOUBLE_EQ(trial_cost(flat, failure(0.5, 0)), trial_cost(flat, failure(0.5, 1)));
}

TEST(Cost, OfAWantedFailureIsNothing) {
  const Scenario hard = wall(Wanted::kFailure);
  EXPECT_EQ(trial_cost(hard, failure(0.3, 0)), 0);
  EXPECT_GE(trial_cost(hard, success(60)), 0.5);
  EXPECT_LT(trial_cost(hard, success(50)), trial_cost(hard, success(10)));
}

TEST(Cost, OfAStraightWalkGrowsWithTheHeadingOverItsBound) {
  Scenario walk = wall(Wanted::kStraight);
  walk.goal = Goal::kWalk;
  walk.heading_bound_rad = 0.1;
  const auto cost = [&](double heading_rad) {
    Measure measure = success(30);
    measure.heading_max_rad = heading_rad;
    return trial_cost(walk, measure);
  };
  EXPECT_EQ(cost(0), 0);
  EXPECT_DOUBLE_EQ(cost(0.1), 0.25);
  EXPECT_DOUBLE_EQ(cost(0.2), 1);
  EXPECT_DOUBLE_EQ(cost(1.0), 1);
  EXPECT_GT(cost(0.15) - cost(0.1), cost(0.1) - cost(0.05));
  EXPECT_GE(trial_cost(walk, failure(0.9, 0)), 1);
}

TEST(Cost, OfAPenaltyIsNothingUpToItsBoundAndOneFromWorstOn) {
  const Penalty penalty{0.1, 0.5, 7};
  EXPECT_EQ(excess(penalty, 0), 0);
  EXPECT_EQ(excess(penalty, 0.1), 0);
  EXPECT_DOUBLE_EQ(excess(penalty, 0.3), 0.5);
  EXPECT_EQ(excess(penalty, 0.5), 1);
  EXPECT_EQ(excess(penalty, 9), 1);
}

}  // namespace
}  // namespace scarab::search
