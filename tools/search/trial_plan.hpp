#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/bus/topics.hpp"
#include "tools/search/description.hpp"

/// Which trials are run for a candidate.
namespace scarab::search {

struct PlannedTrial {
  std::size_t scenario = 0;  ///< index in the description
  std::uint64_t seed = 0;
};

using Plan = std::vector<PlannedTrial>;

/// The trials of one generation: new seeds in each, the same for every candidate of it and on every
/// island (common random numbers: candidates differ by what they are, not by their luck). A pure
/// function of its arguments.
[[nodiscard]] Plan generation_plan(const Description& description, std::uint64_t run_seed,
                                   unsigned generation);

/// Every scenario with each of the seeds of the range, from its first, at most `most`.
[[nodiscard]] Plan plan_over(const Description& description, const SeedRange& seeds,
                             std::uint64_t most = UINT64_MAX);

/// The trial as every program of the project would run it.
[[nodiscard]] scarab_Trial make_trial(const Description& description, const PlannedTrial& planned);

}  // namespace scarab::search
