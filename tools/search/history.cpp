#include "tools/search/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "common/config/scalar.hpp"

namespace scarab::search {
namespace {

double mean_of(const std::vector<Score>& scores, const std::function<double(const Score&)>& part) {
  double sum = 0;
  for (const Score& score : scores) sum += part(score);
  return sum / static_cast<double>(scores.size());
}

}  // namespace

std::string history_header(const Score& any) {
  std::string line = "generation,island,candidates,trials,best,mean,spread";
  for (const ScenarioScore& scenario : any.scenarios) line += "," + scenario.name;
  for (const AddedTerm& term : any.terms) line += "," + term.name;
  return line + "\n";
}

std::string history_line(const HistoryRow& row) {
  using config::format_number;
  std::string line =
      fmt::format("{},{},{},{},{},{},{}", row.generation, row.island, row.candidates, row.trials,
                  format_number(best_objective(row.scores)),
                  format_number(mean_objective(row.scores)), format_number(row.spread));
  const Score& first = row.scores.at(0);
  for (std::size_t i = 0; i < first.scenarios.size(); ++i) {
    line += "," +
            format_number(mean_of(row.scores, [&](const Score& s) { return s.scenarios[i].cost; }));
  }
  for (std::size_t i = 0; i < first.terms.size(); ++i) {
    line +=
        "," + format_number(mean_of(row.scores, [&](const Score& s) { return s.terms[i].value; }));
  }
  return line + "\n";
}

std::string history_until(const std::string& text, std::size_t generation) {
  std::istringstream lines(text);
  std::string result;
  std::string line;
  if (std::getline(lines, line)) result = line + "\n";
  while (std::getline(lines, line) && std::stoul("0" + line) <= generation) result += line + "\n";
  return result;
}

double best_objective(const std::vector<Score>& scores) {
  const auto less = [](const Score& a, const Score& b) { return a.objective < b.objective; };
  return std::min_element(scores.begin(), scores.end(), less)->objective;
}

double mean_objective(const std::vector<Score>& scores) {
  return mean_of(scores, [](const Score& score) { return score.objective; });
}

}  // namespace scarab::search
