#pragma once

#include <string>
#include <vector>

#include "tools/search/objective.hpp"

namespace scarab::search {

/// One island's generation in history.csv.
struct HistoryRow {
  unsigned generation = 0;
  unsigned island = 0;
  std::size_t candidates = 0;  ///< evaluated so far, on all islands
  std::size_t trials = 0;
  double spread = 0;          ///< CmaEs::spread()
  std::vector<Score> scores;  ///< of its candidates
};

/// `generation,island,candidates,trials,best,mean,spread`, then the mean cost of each scenario and
/// each added term over the candidates.
[[nodiscard]] std::string history_header(const Score& any);
[[nodiscard]] std::string history_line(const HistoryRow& row);

/// The header and the rows up to this generation of an earlier history.
[[nodiscard]] std::string history_until(const std::string& text, std::size_t generation);

[[nodiscard]] double best_objective(const std::vector<Score>& scores);
[[nodiscard]] double mean_objective(const std::vector<Score>& scores);

}  // namespace scarab::search
