#include "common/runtime/trial_options.hpp"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "common/bus/sample_fields.hpp"

namespace scarab::runtime {
namespace {

/// Throws CLI::ParseError.
TrialOptions parse(std::vector<std::string> arguments) {
  CLI::App app;
  TrialOptions options;
  add_trial_options(app, options);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  app.parse(arguments);
  return options;
}

scarab_Trial trial_of(const std::vector<std::string>& arguments) {
  return make_trial(parse(arguments), 0, 1);
}

TEST(TrialOptions, DefaultIsThePapersHighestObstacle) {
  const auto trial = trial_of({});
  EXPECT_EQ(bus::text(trial.strategy), "soft+hard");
  EXPECT_EQ(trial.goal, scarab_GOAL_ACROSS);
  EXPECT_EQ(trial.obstacle_height_m, 0.10);
  EXPECT_EQ(trial.time_limit_s, 60);
  EXPECT_TRUE(trial.perturb_cpg_phase);
}

TEST(TrialOptions, GoalFollowsTheObstacle) {
  EXPECT_EQ(trial_of({"--height", "0.05"}).goal, scarab_GOAL_ACROSS);
  EXPECT_EQ(trial_of({"--height", "0"}).goal, scarab_GOAL_TRAVEL);
  EXPECT_EQ(trial_of({"--height", "0.05", "--goal", "travel"}).goal, scarab_GOAL_TRAVEL);
  EXPECT_EQ(trial_of({"--height", "0", "--goal", "none"}).goal, scarab_GOAL_NONE);
  EXPECT_EQ(trial_of({"--height", "0", "--goal", "walk"}).goal, scarab_GOAL_WALK);
}

TEST(TrialOptions, AcrossNothingIsAContradiction) {
  EXPECT_THROW(parse({"--height", "0", "--goal", "across"}), CLI::ParseError);
  TrialOptions options;
  options.height_m = 0;
  options.goal = "across";
  EXPECT_THROW(make_trial(options, 0, 1), std::invalid_argument);
}

TEST(TrialOptions, RefusesWhatIsOutOfRange) {
  for (const auto& [option, values] : std::map<std::string, std::vector<std::string>>{
           {"--height", {"-0.01", "0.51", "high", "nan"}},
           {"--distance", {"0", "-1", "11"}},
           {"--time-limit", {"0", "-5", "36001", "inf"}},
           {"--trials", {"0", "-1", "100001", "1.5"}},
           {"--seed", {"-1", "x"}},
           {"--perturb-position", {"-0.01", "0.3"}},
           {"--perturb-yaw", {"-0.1", "4"}},
           {"--perturb-friction", {"-0.1", "1", "nan"}},
           {"--friction-scale", {"0", "-1", "11"}},
           {"--object-mass", {"-1", "101"}},
           {"--object-diameter", {"-0.1", "1.1"}},
           {"--goal", {"", "home"}}}) {
    for (const auto& value : values) {
      EXPECT_THROW(parse({option, value}), CLI::ParseError) << option << " " << value;
    }
  }
}

TEST(TrialOptions, TrialsOfASeriesDifferInNumberAndSeedAlone) {
  const auto options = parse({"--seed", "40", "--trials", "3"});
  const auto first = make_trial(options, 0, 7);
  auto third = make_trial(options, 2, 9);
  EXPECT_EQ(first.header.trial, 7U);
  EXPECT_EQ(first.seed, 40U);
  EXPECT_EQ(third.header.trial, 9U);
  EXPECT_EQ(third.seed, 42U);
  third.header.trial = first.header.trial;
  third.seed = first.seed;
  EXPECT_EQ(std::memcmp(&first, &third, sizeof(first)), 0);
}

TEST(TrialOptions, NoPerturbationIsNone) {
  const auto trial = trial_of({"--no-perturbation"});
  EXPECT_EQ(trial.perturb_position_m, 0);
  EXPECT_EQ(trial.perturb_yaw_rad, 0);
  EXPECT_EQ(trial.perturb_friction, 0);
  EXPECT_FALSE(trial.perturb_cpg_phase);
}

TEST(TrialOptions, SayHowMuchVariesAndWithWhat) {
  const auto trial =
      trial_of({"--perturb-position", "0.03", "--perturb-yaw", "0.1", "--perturb-friction", "0.2",
                "--friction-scale", "0.75", "--object-mass", "3", "--object-diameter", "0.14"});
  EXPECT_EQ(trial.perturb_position_m, 0.03);
  EXPECT_EQ(trial.perturb_yaw_rad, 0.1);
  EXPECT_EQ(trial.perturb_friction, 0.2);
  EXPECT_EQ(trial.friction_scale, 0.75);
  EXPECT_EQ(trial.object_mass_kg, 3);
  EXPECT_EQ(trial.object_diameter_m, 0.14);
}

TEST(TrialOptions, StrategyThatDoesNotFitTheTopicIsRefused) {
  EXPECT_THROW(parse({"--strategy", std::string(64, 's')}), CLI::ParseError);
}

}  // namespace
}  // namespace scarab::runtime
