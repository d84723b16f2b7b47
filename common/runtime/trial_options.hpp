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
  std::string goal;  ///< none, travel, across, walk; empty: across with an obstacle, else travel
  double height_m = 0.10;    ///< of the obstacle; 0 none
  double distance_m = 1.46;  ///< for travel (paper, experiment 1) and walk
  double time_limit_s = 60;  ///< simulated (paper, experiment 2: one minute)
  std::uint64_t seed = 1;    ///< of the first trial; each further one has the next
  unsigned trials = 1;
  double perturb_position_m = 0.02;              ///< start position: uniform in +- this, x and y
  double perturb_yaw_rad = 0.05235987755982988;  ///< start heading: uniform in +- this; 3 deg
  double perturb_friction = 0.10;                ///< each coefficient: uniform in 1 +- this
  bool perturb = true;           ///< false: none of the three, and the same CPG phase in each trial
  double friction_scale = 1;     ///< of every friction coefficient
  double object_mass_kg = 0;     ///< 0: as configured
  double object_diameter_m = 0;  ///< 0: as configured
};

/// Adds an option for each of them, with its range; options that contradict each other are a parse
/// error.
void add_trial_options(CLI::App& app, TrialOptions& options);

/// Adds --worker: the trials come from stdin. It excludes every option that `app` has so far.
void add_worker_flag(CLI::App& app, bool& worker);

/// Trial `index` (from 0) of the series as number `number` of the run; header.stamp_ns is the
/// caller's. Throws std::invalid_argument where options contradict each other.
scarab_Trial make_trial(const TrialOptions& options, unsigned index, std::uint32_t number);

}  // namespace scarab::runtime
