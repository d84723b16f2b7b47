#pragma once

#include <filesystem>

#include "common/runtime/trial_options.hpp"
#include "tools/sim/composition.hpp"

namespace scarab::sim {

struct SimOptions {
  runtime::TrialOptions trials;
  std::filesystem::path output;   ///< MCAP; empty: none
  std::filesystem::path results;  ///< CSV; empty: none
  bool quiet = false;
};

/// Runs the series in this process and reports it like the experiment service; returns the
/// program's exit code: 0 all trials succeeded, 1 not, 130 interrupted.
int simulate(const SimOptions& options, const Configuration& configuration);

}  // namespace scarab::sim
