#include "tools/search/trial_plan.hpp"

#include "common/random/random.hpp"
#include "common/runtime/trial_options.hpp"

namespace scarab::search {
namespace {

const char* goal_name(Goal goal) {
  switch (goal) {
    case Goal::kTravel:
      return "travel";
    case Goal::kAcross:
      return "across";
    case Goal::kWalk:
      return "walk";
    case Goal::kNone:
      break;
  }
  return "none";
}

}  // namespace

Plan generation_plan(const Description& description, std::uint64_t run_seed, unsigned generation) {
  const SeedRange& range = description.seeds.search;
  const auto count = static_cast<double>(range.last - range.first + 1);
  Plan plan;
  for (std::size_t scenario = 0; scenario < description.scenarios.size(); ++scenario) {
    // A stream a scenario: another one's number of seeds does not change those of this one.
    const auto stream = random::stream(description.scenarios[scenario].name);
    for (unsigned k = 0; k < description.scenarios[scenario].seeds; ++k) {
      const std::uint64_t index = (std::uint64_t{generation} << 16U) + k;
      const double share = random::uniform(run_seed, stream, index);
      plan.push_back({scenario, range.first + static_cast<std::uint64_t>(share * count)});
    }
  }
  return plan;
}

Plan plan_over(const Description& description, const SeedRange& seeds, std::uint64_t most) {
  Plan plan;
  for (std::size_t scenario = 0; scenario < description.scenarios.size(); ++scenario) {
    for (std::uint64_t k = 0; k <= seeds.last - seeds.first && k < most; ++k) {
      plan.push_back({scenario, seeds.first + k});
    }
  }
  return plan;
}

scarab_Trial make_trial(const Description& description, const PlannedTrial& planned) {
  const Scenario& scenario = description.scenarios.at(planned.scenario);
  runtime::TrialOptions options;
  options.strategy = scenario.strategy;
  options.goal = goal_name(scenario.goal);
  options.height_m = scenario.height_m;
  options.distance_m = scenario.distance_m;
  options.time_limit_s = scenario.time_limit_s;
  options.seed = planned.seed;
  options.perturb_position_m = description.perturbation.position_m;
  options.perturb_yaw_rad = description.perturbation.yaw_rad;
  options.perturb_friction = description.perturbation.friction;
  options.friction_scale = scenario.friction_scale;
  options.object_mass_kg = scenario.object_mass_kg;
  options.object_diameter_m = scenario.object_diameter_m;
  scarab_Trial trial = runtime::make_trial(options, 0, 1);
  trial.perturb_cpg_phase = description.perturbation.cpg_phase;
  return trial;
}

}  // namespace scarab::search
