#include "tools/search/trial_plan.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/unit/search/description_text.hpp"

namespace scarab::search {
namespace {

std::vector<std::uint64_t> seeds_of(const Plan& plan) {
  std::vector<std::uint64_t> seeds;
  for (const PlannedTrial& trial : plan) seeds.push_back(trial.seed);
  return seeds;
}

TEST(GenerationPlan, HasTheTrialsEachScenarioAsksFor) {
  const Plan plan = generation_plan(description_from(description_text()), 1, 1);
  std::vector<std::size_t> scenarios;
  for (const PlannedTrial& trial : plan) scenarios.push_back(trial.scenario);
  EXPECT_EQ(scenarios, (std::vector<std::size_t>{0, 0, 1, 1, 1}));
}

TEST(GenerationPlan, DrawsNewSeedsForEachGenerationAndRun) {
  const Description description = description_from(description_text());
  std::set<std::vector<std::uint64_t>> seen;
  for (unsigned run = 1; run <= 3; ++run) {
    for (unsigned generation = 1; generation <= 20; ++generation) {
      seen.insert(seeds_of(generation_plan(description, run, generation)));
    }
  }
  EXPECT_EQ(seen.size(), 60U);
  EXPECT_EQ(seeds_of(generation_plan(description, 1, 7)),
            seeds_of(generation_plan(description, 1, 7)));
}

TEST(GenerationPlan, StaysWithinTheSearchSeeds) {
  const Description description = description_from(
      description_text("search: {first: 1, last: 899999}", "search: {first: 100, last: 102}"));
  std::set<std::uint64_t> seen;
  for (unsigned generation = 1; generation <= 50; ++generation) {
    for (const auto seed : seeds_of(generation_plan(description, 1, generation))) seen.insert(seed);
  }
  EXPECT_EQ(seen, (std::set<std::uint64_t>{100, 101, 102}));
}

TEST(PlanOver, TakesEverySeedOfTheRangeForEachScenario) {
  const Description description = description_from(description_text());
  EXPECT_EQ(seeds_of(plan_over(description, {5, 7})),
            (std::vector<std::uint64_t>{5, 6, 7, 5, 6, 7}));
  EXPECT_EQ(seeds_of(plan_over(description, {5, 7}, 1)), (std::vector<std::uint64_t>{5, 5}));
}

TEST(MakeTrial, SaysWhatTheScenarioSays) {
  const Description description = description_from(description_text());
  const scarab_Trial flat = make_trial(description, {0, 17});
  EXPECT_STREQ(flat.strategy, "soft");
  EXPECT_EQ(flat.goal, scarab_GOAL_TRAVEL);
  EXPECT_EQ(flat.seed, 17U);
  EXPECT_EQ(flat.obstacle_height_m, 0);
  EXPECT_EQ(flat.perturb_position_m, description.perturbation.position_m);
  EXPECT_EQ(flat.perturb_yaw_rad, description.perturbation.yaw_rad);
  EXPECT_EQ(flat.perturb_friction, description.perturbation.friction);
  EXPECT_TRUE(flat.perturb_cpg_phase);
  const scarab_Trial wall = make_trial(description, {1, 17});
  EXPECT_EQ(wall.goal, scarab_GOAL_ACROSS);
  EXPECT_EQ(wall.obstacle_height_m, 0.1);
}

}  // namespace
}  // namespace scarab::search
