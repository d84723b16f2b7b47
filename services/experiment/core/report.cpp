#include "services/experiment/core/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace scarab::experiment {
namespace {

double speed(const Progress& progress) {
  return progress.wall_s > 0 ? progress.time_s / progress.wall_s : 0;
}

/// Quotes a CSV field where it has to be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string changes_field(const Outcome& outcome) {
  std::string text;
  for (const auto& change : outcome.changes) {
    if (!text.empty()) text += "; ";
    text += change.state + " " + fmt::format("{:.1f}", change.time_s);
  }
  return text;
}

}  // namespace

std::string progress_line(const Progress& progress) {
  return fmt::format("{:7.1f} s  {:<10} object {:5.2f} m  {:5.1f} x real time", progress.time_s,
                     progress.state, progress.travel_m, speed(progress));
}

std::string change_line(const BehaviourChange& change) {
  return fmt::format("{:7.1f} s  {:<10} {}", change.time_s, change.state, change.reason);
}

std::string result_line(const Outcome& outcome) {
  const std::string over =
      outcome.height_m > 0 ? fmt::format("obstacle {:.2f} m", outcome.height_m) : "no obstacle";
  return fmt::format(
      "result: {} after {:.1f} s: {} (trial {}: {}, {}, seed {}; {:.1f} x real time)",
      outcome.success ? "success" : "failure", outcome.end.time_s, outcome.reason, outcome.number,
      outcome.strategy, over, outcome.seed, speed(outcome.end));
}

std::string summary_line(const std::vector<Outcome>& outcomes) {
  std::vector<double> times;
  for (const auto& outcome : outcomes) {
    if (outcome.success) times.push_back(outcome.end.time_s);
  }
  std::string text =
      fmt::format("summary: {} of {} trials succeeded", times.size(), outcomes.size());
  if (times.empty()) return text;
  std::sort(times.begin(), times.end());
  const double median = (times[(times.size() - 1) / 2] + times[times.size() / 2]) / 2;
  return text + fmt::format("; time of the successes {:.1f} to {:.1f} s, median {:.1f} s",
                            times.front(), times.back(), median);
}

std::string results_csv(const std::vector<Outcome>& outcomes) {
  std::string text =
      "trial,strategy,obstacle_height_m,seed,success,time_s,object_travel_m,speed_x_real_time,"
      "changes_s,reason\n";
  for (const auto& outcome : outcomes) {
    text += fmt::format("{},{},{:.4f},{},{:d},{:.3f},{:.4f},{:.2f},", outcome.number,
                        field(outcome.strategy), outcome.height_m, outcome.seed, outcome.success,
                        outcome.end.time_s, outcome.end.travel_m, speed(outcome.end)) +
            field(changes_field(outcome)) + "," + field(outcome.reason) + "\n";
  }
  return text;
}

bool all_succeeded(const std::vector<Outcome>& outcomes) {
  return std::all_of(outcomes.begin(), outcomes.end(),
                     [](const Outcome& outcome) { return outcome.success; });
}

}  // namespace scarab::experiment
