#include <gtest/gtest.h>

#include "services/experiment/adapter.hpp"

namespace scarab::experiment {
namespace {

TEST(ToTrial, SaysAllThatTheLineSays) {
  TrialLine line;
  line.strategy = "boxing";
  line.goal = Goal::kWalk;
  line.height_m = 0.01;
  line.distance_m = 0.02;
  line.time_limit_s = 0.03;
  line.seed = 4;
  line.perturb_position_m = 0.05;
  line.perturb_yaw_rad = 0.06;
  line.perturb_friction = 0.07;
  line.perturb_cpg_phase = true;
  line.friction_scale = 0.08;
  line.object_mass_kg = 0.09;
  line.object_diameter_m = 0.10;
  const auto trial = to_trial(line, 11);
  EXPECT_EQ(trial.header.trial, 11U);
  EXPECT_STREQ(trial.strategy, "boxing");
  EXPECT_EQ(trial.goal, scarab_GOAL_WALK);
  EXPECT_EQ(trial.obstacle_height_m, 0.01);
  EXPECT_EQ(trial.goal_distance_m, 0.02);
  EXPECT_EQ(trial.time_limit_s, 0.03);
  EXPECT_EQ(trial.seed, 4U);
  EXPECT_EQ(trial.perturb_position_m, 0.05);
  EXPECT_EQ(trial.perturb_yaw_rad, 0.06);
  EXPECT_EQ(trial.perturb_friction, 0.07);
  EXPECT_TRUE(trial.perturb_cpg_phase);
  EXPECT_EQ(trial.friction_scale, 0.08);
  EXPECT_EQ(trial.object_mass_kg, 0.09);
  EXPECT_EQ(trial.object_diameter_m, 0.10);
}

}  // namespace
}  // namespace scarab::experiment
