#pragma once

#include <cstdint>
#include <string>

#include "common/bus/topics.hpp"

namespace CLI {
class App;
}

namespace scarab::runtime {

/// A series of trials that differ in their seed alone, as a person asks for them.
struct TrialOptions {
  std::string strategy = "soft+hard";
  std::string goal;        ///< none, travel, across; empty: across with an obstacle, travel without
  double height_m = 0.10;  ///< of the obstacle; 0 none
  double distance_m = 1.46;  ///< for travel (paper, experiment 1)
  double time_limit_s = 60;  ///< simulated (paper, experiment 2: one minute)
  std::uint64_t seed = 1;    ///< of the first trial; each further one has the next
  unsigned trials = 1;
  bool perturb = true;  ///< start pose and CPG phase vary with the seed
};

/// Adds --strategy, --height, --goal, --distance, --time-limit, --seed, --trials,
/// --no-perturbation, with their ranges; options that contradict each other are a parse error.
void add_trial_options(CLI::App& app, TrialOptions& options);

/// Trial `index` (from 0) of the series as number `number` of the run; header.stamp_ns is the
/// caller's. Throws std::invalid_argument where options contradict each other.
scarab_Trial make_trial(const TrialOptions& options, unsigned index, std::uint32_t number);

}  // namespace scarab::runtime
