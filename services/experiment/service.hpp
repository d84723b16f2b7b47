#pragma once

#include <filesystem>

#include "common/runtime/options.hpp"
#include "common/runtime/trial_options.hpp"

namespace scarab::experiment {

struct ExperimentOptions {
  runtime::BusOptions bus;
  runtime::Expectation expect;
  runtime::TrialOptions trials;
  std::filesystem::path results;     ///< CSV; empty: none
  std::filesystem::path fault_file;  ///< FaultFile; empty: none
  unsigned ready_limit_s = 20;       ///< how long to wait for the stack
  unsigned silence_limit_s = 30;     ///< how long a trial may be silent
  bool quiet = false;                ///< results only
  bool worker = false;               ///< trials come from stdin
};

/// Runs the trials told on stdin, one a line, and writes a row of results to stdout for each
/// (worker.hpp); returns the program's exit code.
int serve_lines(const ExperimentOptions& options);

/// Runs the series and reports it on stdout; returns the program's exit code: 0 all trials
/// succeeded, 1 not, 130 interrupted.
int conduct(const ExperimentOptions& options);

}  // namespace scarab::experiment
