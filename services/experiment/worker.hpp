#pragma once

#include <cstdint>
#include <functional>
#include <ostream>

#include "services/experiment/core/outcome.hpp"
#include "services/experiment/core/trial_line.hpp"
#include "services/experiment/interrupted.hpp"

namespace scarab::experiment {

/// Where a worker's trials come from, where its results go, and what runs them.
struct Worker {
  int input = 0;           ///< file descriptor of the trial lines
  std::ostream* output{};  ///< of the result rows; nothing else is written to it
  std::function<bool()> interrupted;
  /// The n-th trial, from 1. Throws Interrupted; any other exception for a trial without a result.
  std::function<Outcome(const TrialLine& line, std::uint32_t n)> run;
};

/// Runs trial after trial: a line in, a row out, until the input ends. The same for trials in
/// this process and on a stack, so that equal trials give equal bytes. Returns the program's exit
/// code: 0 at the end of the input, 1 after a trial that has no result, 2 after a line that is no
/// trial (both are told in a last row), 130 interrupted (the trial under way has no row).
int work(const Worker& worker);

}  // namespace scarab::experiment
