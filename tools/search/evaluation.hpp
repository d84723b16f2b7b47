#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "tools/search/description.hpp"
#include "tools/search/measure.hpp"
#include "tools/search/trial_plan.hpp"
#include "tools/sim/composition.hpp"

namespace scarab::search {

struct EvaluationOptions {
  unsigned jobs = 1;    ///< threads
  bool give_up = true;  ///< abandon a trial in which nothing moves any more
  const std::atomic<bool>* interrupted = nullptr;
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< called by one thread
};

/// One candidate's measures, in the order of the plan.
using Measures = std::vector<Measure>;

/// Runs one trial. A configuration in which it cannot be run (a start pose inside the ground, say)
/// is a failure without any way made.
[[nodiscard]] Measure run_planned(const Description& description,
                                  const sim::Configuration& configuration,
                                  const PlannedTrial& planned, const EvaluationOptions& options);

/// Runs the plan with every configuration, trials side by side on options.jobs threads. The result
/// does not depend on their number: a trial is a pure function of configuration and plan. Empty if
/// interrupted.
[[nodiscard]] std::vector<Measures> evaluate(const Description& description,
                                             const std::vector<sim::Configuration>& configurations,
                                             const Plan& plan, const EvaluationOptions& options);

}  // namespace scarab::search
