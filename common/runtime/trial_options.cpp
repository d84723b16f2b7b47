#include "common/runtime/trial_options.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <vector>

#include "common/bus/sample_fields.hpp"
#include "common/runtime/trial_limits.hpp"

namespace scarab::runtime {
namespace {

/// Like CLI::Range, but refuses nan, too.
CLI::Validator within(const Limits& limits) {
  const std::string description = CLI::Range(limits.low, limits.high).get_description();
  const auto check = [limits, description](const std::string& text) {
    double value = 0;
    const bool inside =
        CLI::detail::lexical_cast(text, value) && value >= limits.low && value <= limits.high;
    return inside ? std::string() : text + " is no " + description;
  };
  return {check, description};
}

scarab_GoalKind goal_of(const TrialOptions& options) {
  if (options.goal == "none") return scarab_GOAL_NONE;
  if (options.goal == "travel") return scarab_GOAL_TRAVEL;
  if (options.goal == "walk") return scarab_GOAL_WALK;
  if (options.goal == "across" && options.height_m == 0) {
    throw std::invalid_argument("goal across needs an obstacle: --height greater than 0");
  }
  if (options.goal == "across") return scarab_GOAL_ACROSS;
  return options.height_m > 0 ? scarab_GOAL_ACROSS : scarab_GOAL_TRAVEL;
}

void add_perturbation_options(CLI::App& app, TrialOptions& options) {
  app.add_option("--perturb-position", options.perturb_position_m,
                 "start position: uniform in +- this by the seed, m")
      ->check(within(kPerturbPositionLimitsM))
      ->capture_default_str();
  app.add_option("--perturb-yaw", options.perturb_yaw_rad,
                 "start heading: uniform in +- this by the seed, rad")
      ->check(within(kPerturbYawLimitsRad))
      ->capture_default_str();
  app.add_option("--perturb-friction", options.perturb_friction,
                 "every friction coefficient: uniform in 1 +- this by the seed")
      ->check(within(kPerturbFrictionLimits))
      ->capture_default_str();
  app.add_flag("!--no-perturbation", options.perturb,
               "start every trial from the same pose and CPG phase, with the same friction");
}

void add_scene_options(CLI::App& app, TrialOptions& options) {
  app.add_option("--friction-scale", options.friction_scale, "of every friction coefficient")
      ->check(within(kFrictionScaleLimits))
      ->capture_default_str();
  app.add_option("--object-mass", options.object_mass_kg,
                 "mass of the object, kg; 0: as configured")
      ->check(within(kObjectMassLimitsKg))
      ->capture_default_str();
  app.add_option("--object-diameter", options.object_diameter_m,
                 "diameter of the object, m; 0: as configured")
      ->check(within(kObjectDiameterLimitsM))
      ->capture_default_str();
}

}  // namespace

void add_trial_options(CLI::App& app, TrialOptions& options) {
  app.add_option("--strategy", options.strategy,
                 "soft, boxing, stationary, soft+hard, ... (config/supervisor)")
      ->capture_default_str();
  app.add_option("--height", options.height_m, "height of the obstacle, m; 0: none")
      ->check(within(kHeightLimitsM))
      ->capture_default_str();
  app.add_option(
         "--goal", options.goal,
         "across (the obstacle), travel (the object, a distance), walk (the robot, a distance) "
         "or none; default: across if there is an obstacle, else travel")
      ->check(CLI::IsMember({"across", "travel", "walk", "none"}));
  app.add_option("--distance", options.distance_m, "for goals travel and walk, m")
      ->check(within(kDistanceLimitsM))
      ->capture_default_str();
  app.add_option("--time-limit", options.time_limit_s, "simulated time to reach the goal, s")
      ->check(within(kTimeLimitsS))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the first trial; each further one has the next")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--trials", options.trials, "how many trials")
      ->check(CLI::Range(1U, 100000U))
      ->capture_default_str();
  add_perturbation_options(app, options);
  add_scene_options(app, options);
  app.final_callback([&options] {
    try {
      (void)make_trial(options, 0, 1);
    } catch (const std::exception& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

void add_worker_flag(CLI::App& app, bool& worker) {
  const std::vector<CLI::Option*> others = app.get_options();
  auto* flag = app.add_flag("--worker", worker,
                            "read one trial a line from stdin (JSON) and write its result to "
                            "stdout, until the end of stdin (services/experiment/README.md)");
  for (auto* other : others) {
    if (other != app.get_help_ptr()) flag->excludes(other);
  }
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
  trial.perturb_position_m = options.perturb ? options.perturb_position_m : 0;
  trial.perturb_yaw_rad = options.perturb ? options.perturb_yaw_rad : 0;
  trial.perturb_friction = options.perturb ? options.perturb_friction : 0;
  trial.perturb_cpg_phase = options.perturb;
  trial.friction_scale = options.friction_scale;
  trial.object_mass_kg = options.object_mass_kg;
  trial.object_diameter_m = options.object_diameter_m;
  return trial;
}

}  // namespace scarab::runtime
