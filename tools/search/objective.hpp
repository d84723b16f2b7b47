#pragma once

#include <string>
#include <vector>

#include "tools/search/description.hpp"
#include "tools/search/evaluation.hpp"
#include "tools/search/trial_plan.hpp"

namespace scarab::search {

/// How one scenario went.
struct ScenarioScore {
  std::string name;
  unsigned trials = 0;
  unsigned successes = 0;
  double cost = 0;         ///< mean over its trials
  double time_s = 0;       ///< mean of the successes; 0 without any
  double heading_rad = 0;  ///< largest deviation of any trial
};

/// A term that is added to the weighted mean of the scenarios' costs.
struct AddedTerm {
  std::string name;
  double measured = 0;  ///< mean of the measure, or difference of times over their limits
  double value = 0;     ///< as added, with its weight
};

struct Score {
  double objective = 0;
  std::vector<ScenarioScore> scenarios;  ///< in the description's order
  std::vector<AddedTerm> terms;          ///< penalties and orders
};

/// Objective of one candidate from its trials:
///     sum_s w_s c_s / sum_s w_s  +  penalties  +  orders
/// with c_s the mean cost of scenario s; a penalty is averaged over the scenarios like the costs.
[[nodiscard]] Score score(const Description& description, const Plan& plan,
                          const Measures& measures);

/// Table of its parts, one line each, for a person.
[[nodiscard]] std::string score_table(const Score& score);

}  // namespace scarab::search
