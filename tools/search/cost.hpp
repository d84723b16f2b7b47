#pragma once

#include "tools/search/description.hpp"
#include "tools/search/measure.hpp"

/// The objective's terms for one trial; docs/search.md has them as formulas.
namespace scarab::search {

/// Cost of a trial of this scenario, in [0, 2]. For
/// - success: the share of the time limit that it took, in [0, 1]; a failure 1 plus what was
///   missing, in [1, 2];
/// - failure: 0 for a failure; a success 1 less half the share of the time limit that it took;
/// - straight: heading deviation over its bound, 0.25 at the bound and 1 at twice the bound and
///   beyond; a trial that does not arrive as for success.
[[nodiscard]] double trial_cost(const Scenario& scenario, const Measure& measure);

/// What the trial lacked of its goal, in [0, 1]: 0.6 for the way, 0.4 for the rise of the object's
/// axis to the obstacle's height, where there is one to cross.
[[nodiscard]] double missing_share(const Scenario& scenario, const Measure& measure);

/// A penalty's term for one trial, without its weight: 0 up to the bound, 1 from `worst` on.
[[nodiscard]] double excess(const Penalty& penalty, double measured);

}  // namespace scarab::search
