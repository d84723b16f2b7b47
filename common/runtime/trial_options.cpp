#include "common/runtime/trial_options.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "common/bus/sample_fields.hpp"

namespace scarab::runtime {
namespace {

// Start poses of the prototype's trials that these parameters were found with.
constexpr double kPerturbPositionM = 0.01;
constexpr double kPerturbYawRad = 0.034906585039886591;  // 2 deg
constexpr double kHeightMostM = 0.5;
constexpr double kDistanceMostM = 10;
constexpr double kTimeLimitMostS = 36000;

/// Like CLI::Range, but refuses nan, too.
CLI::Validator within(double low, double high) {
  const std::string description = CLI::Range(low, high).get_description();
  const auto check = [low, high, description](const std::string& text) {
    double value = 0;
    const bool inside = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
    return inside ? std::string() : text + " is no " + description;
  };
  return {check, description};
}

scarab_GoalKind goal_of(const TrialOptions& options) {
  if (options.goal == "none") return scarab_GOAL_NONE;
  if (options.goal == "travel") return scarab_GOAL_TRAVEL;
  if (options.goal == "across" && options.height_m == 0) {
    throw std::invalid_argument("goal across needs an obstacle: --height greater than 0");
  }
  if (options.goal == "across") return scarab_GOAL_ACROSS;
  return options.height_m > 0 ? scarab_GOAL_ACROSS : scarab_GOAL_TRAVEL;
}

}  // namespace

void add_trial_options(CLI::App& app, TrialOptions& options) {
  app.add_option("--strategy", options.strategy,
                 "soft, boxing, stationary, soft+hard, ... (config/supervisor)")
      ->capture_default_str();
  app.add_option("--height", options.height_m, "height of the obstacle, m; 0: none")
      ->check(within(0.0, kHeightMostM))
      ->capture_default_str();
  app.add_option("--goal", options.goal,
                 "across (the obstacle), travel (a distance) or none; default: across if there is "
                 "an obstacle, else travel")
      ->check(CLI::IsMember({"across", "travel", "none"}));
  app.add_option("--distance", options.distance_m, "for goal travel, m")
      ->check(within(0.01, kDistanceMostM))
      ->capture_default_str();
  app.add_option("--time-limit", options.time_limit_s, "simulated time to reach the goal, s")
      ->check(within(0.1, kTimeLimitMostS))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the first trial; each further one has the next")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--trials", options.trials, "how many trials")
      ->check(CLI::Range(1U, 100000U))
      ->capture_default_str();
  app.add_flag("!--no-perturbation", options.perturb,
               "start every trial from the same pose and CPG phase");
  app.final_callback([&options] {
    try {
      (void)make_trial(options, 0, 1);
    } catch (const std::exception& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

scarab_Trial make_trial(const TrialOptions& options, unsigned index, std::uint32_t number) {
  scarab_Trial trial{};
  trial.header.trial = number;
  bus::assign(trial.strategy, options.strategy);
  trial.goal = goal_of(options);
  trial.goal_distance_m = options.distance_m;
  trial.time_limit_s = options.time_limit_s;
  trial.obstacle_height_m = options.height_m;
  trial.seed = options.seed + index;
  trial.perturb_position_m = options.perturb ? kPerturbPositionM : 0;
  trial.perturb_yaw_rad = options.perturb ? kPerturbYawRad : 0;
  trial.perturb_cpg_phase = options.perturb;
  return trial;
}

}  // namespace scarab::runtime
