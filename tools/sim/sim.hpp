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
  bool worker = false;  ///< trials come from stdin
};

/// Runs the trials told on stdin, one a line, and writes a row of results to stdout for each
/// (services/experiment/worker.hpp); returns the program's exit code.
int serve_lines(const SimOptions& options, const Configuration& configuration);

/// Runs the series in this process and reports it like the experiment service; returns the
/// program's exit code: 0 all trials succeeded, 1 not, 130 interrupted.
int simulate(const SimOptions& options, const Configuration& configuration);

}  // namespace scarab::sim
