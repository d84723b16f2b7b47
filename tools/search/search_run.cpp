#include "tools/search/search_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "common/random/random.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/screen.hpp"
#include "tools/search/cma_es.hpp"
#include "tools/search/evaluation.hpp"
#include "tools/search/history.hpp"
#include "tools/search/interruption.hpp"
#include "tools/search/objective.hpp"

namespace scarab::search {
namespace {

using Clock = std::chrono::steady_clock;
using Points = std::vector<CmaEs::Point>;

double minutes_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count() / 60;
}

class Search {
 public:
  Search(const Problem& problem, const RunOptions& options)
      : problem_(problem),
        options_(options),
        directory_(options.out),
        interrupted_(watch_for_interruption()),
        screen_(options.quiet),
        validation_(plan_over(problem.description(), problem.description().seeds.validation)) {
    directory_.claim(problem, options.identity, options.fresh);
    begin_islands();
    take_up();
  }

  int run() {
    if (!winner_ && !validate(0, {problem_.space().start_point()})) return stop();
    while (costs_.size() < options_.generations && !out_of_time()) {
      if (!generation()) return stop();
    }
    if (!costs_.empty() && !is_due(costs_.size()) && !validate_islands()) return stop();
    screen_.line(
        fmt::format("winner: objective {:.4f} on the validation seeds (base {:.4f}), of "
                    "generation {}; {}",
                    winner_->objective, winner_->start_objective, winner_->generation,
                    (directory_.path() / "winner.yaml").string()));
    return runtime::kExitSuccess;
  }

 private:
  [[nodiscard]] const Description& description() const { return problem_.description(); }
  [[nodiscard]] bool is_due(std::size_t generation) const {
    return generation % description().optimiser.validate_every == 0;
  }
  [[nodiscard]] bool out_of_time() const {
    return options_.minutes > 0 && minutes_since(started_) >= options_.minutes;
  }

  void begin_islands() {
    const Optimiser& optimiser = description().optimiser;
    for (unsigned island = 0; island < options_.identity.islands; ++island) {
      const auto seed = static_cast<std::uint32_t>(
          random::bits(options_.identity.seed, random::stream("island"), island));
      islands_.emplace_back(problem_.space().start_point(), optimiser.sigma, optimiser.population,
                            seed);
    }
  }

  /// Tells the optimisers what they were told before an interruption.
  void take_up() {
    costs_ = directory_.read_costs();
    for (const GenerationCosts& generation : costs_) {
      if (generation.size() != islands_.size()) {
        throw WrongDirectory(directory_.path().string() + ": costs.csv is not of all islands");
      }
      for (std::size_t i = 0; i < islands_.size(); ++i) islands_[i].tell(generation[i]);
    }
    winner_ = directory_.read_winner(problem_.space());
    // It is written before costs.csv, so that it may be a generation ahead of it.
    history_ = history_until(directory_.read("history.csv").value_or(""), costs_.size());
    for (const GenerationCosts& generation : costs_) trials_ += trials_of(generation);
    if (!costs_.empty()) screen_.line(fmt::format("goes on after generation {}", costs_.size()));
  }

  /// How many trials a generation took.
  [[nodiscard]] std::size_t trials_of(const GenerationCosts& generation) const {
    std::size_t candidates = 0;
    for (const auto& island : generation) candidates += island.size();
    return candidates * generation_plan(description(), options_.identity.seed, 1).size();
  }

  /// Scores of points over a plan; empty if interrupted.
  std::vector<Score> evaluate_points(const Points& points, const Plan& plan,
                                     const std::string& what) {
    std::vector<sim::Configuration> configurations;
    for (const auto& point : points) {
      const auto values = problem_.space().values(point);
      configurations.push_back(problem_.tree(values, Fidelity::kSearch).build());
    }
    EvaluationOptions options;
    options.jobs = options_.jobs;
    options.interrupted = &interrupted_;
    options.progress = [&](std::size_t done, std::size_t all) {
      screen_.progress(fmt::format("{}: {}/{} trials", what, done, all));
    };
    const auto began = Clock::now();
    std::vector<Score> scores;
    for (const Measures& measures : evaluate(description(), configurations, plan, options)) {
      scores.push_back(score(description(), plan, measures));
    }
    const double minutes = minutes_since(began);
    trials_per_s_ = static_cast<double>(points.size() * plan.size()) / std::max(minutes * 60, 1e-9);
    return scores;
  }

  /// One generation on every island; false if interrupted.
  bool generation() {
    const auto number = static_cast<unsigned>(costs_.size() + 1);
    const auto began = Clock::now();
    const Plan plan = generation_plan(description(), options_.identity.seed, number);
    Points points;
    for (const CmaEs& island : islands_) {
      points.insert(points.end(), island.ask().begin(), island.ask().end());
    }
    const auto scores = evaluate_points(points, plan, fmt::format("generation {}", number));
    if (scores.empty()) return false;
    GenerationCosts costs;
    const std::string lines = tell(number, plan, scores, costs);
    costs_.push_back(costs);
    best_points_ = best_of(points, scores);
    if (is_due(number) && !validate_islands()) return false;
    if (history_.empty()) history_ = history_header(scores[0]);
    history_ += lines;
    directory_.write("history.csv", history_);
    directory_.write_costs(costs_);
    report(number, scores, minutes_since(began));
    return true;
  }

  /// Hands each island its candidates' costs; returns the rows of the history.
  std::string tell(unsigned number, const Plan& plan, const std::vector<Score>& scores,
                   GenerationCosts& costs) {
    const std::size_t population = scores.size() / islands_.size();
    trials_ += scores.size() * plan.size();
    std::string lines;
    for (std::size_t i = 0; i < islands_.size(); ++i) {
      const auto first = scores.begin() + static_cast<std::ptrdiff_t>(i * population);
      const std::vector<Score> own(first, first + static_cast<std::ptrdiff_t>(population));
      lines += history_line({number, static_cast<unsigned>(i), number * scores.size(), trials_,
                             islands_[i].spread(), own});
      std::vector<double> told;
      for (const Score& s : own) told.push_back(s.objective);
      islands_[i].tell(told);
      costs.push_back(told);
    }
    return lines;
  }

  /// The best candidate of each island.
  [[nodiscard]] Points best_of(const Points& points, const std::vector<Score>& scores) const {
    const std::size_t population = scores.size() / islands_.size();
    Points best;
    for (std::size_t i = 0; i < islands_.size(); ++i) {
      std::size_t at = i * population;
      for (std::size_t k = at; k < (i + 1) * population; ++k) {
        if (scores[k].objective < scores[at].objective) at = k;
      }
      best.push_back(points[at]);
    }
    return best;
  }

  /// Means and best candidates of the islands against the winner so far; false if interrupted.
  bool validate_islands() {
    Points points = best_points_;
    for (const CmaEs& island : islands_) points.push_back(island.mean());
    return validate(static_cast<unsigned>(costs_.size()), points);
  }

  bool validate(unsigned generation, const Points& points) {
    const auto scores = evaluate_points(points, validation_, "validation");
    if (scores.empty()) return false;
    bool better = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (winner_ && scores[i].objective >= winner_->objective) continue;
      const double start = winner_ ? winner_->start_objective : scores[i].objective;
      winner_ = Winner{generation, scores[i].objective, start, problem_.space().values(points[i])};
      directory_.write("winner.txt", score_table(scores[i]));
      screen_.detail(
          fmt::format("validation, generation {}:\n{}", generation, score_table(scores[i])));
      better = true;
    }
    if (better) directory_.write_winner(*winner_, problem_.space());
    return true;
  }

  void report(unsigned number, const std::vector<Score>& scores, double minutes) {
    double left = minutes * (options_.generations - number);
    if (options_.minutes > 0) left = std::min(left, options_.minutes - minutes_since(started_));
    screen_.detail(fmt::format(
        "generation {}/{}  best {:.4f}  mean {:.4f}  spread {:.4f}  winner {:.4f}  {:.1f} trials/s"
        "  {:.0f} min left",
        number, options_.generations, best_objective(scores), mean_objective(scores),
        islands_[0].spread(), winner_->objective, trials_per_s_, std::max(0.0, left)));
  }

  [[nodiscard]] int stop() {
    screen_.line(fmt::format("interrupted; the same command goes on after generation {}",
                             directory_.read_costs().size()));
    return runtime::kExitInterrupted;
  }

  const Problem& problem_;
  const RunOptions& options_;
  RunDirectory directory_;
  const std::atomic<bool>& interrupted_;
  runtime::Screen screen_;
  Plan validation_;
  std::vector<CmaEs> islands_;
  std::vector<GenerationCosts> costs_;
  Points best_points_;  ///< of the newest generation
  std::optional<Winner> winner_;
  std::string history_;
  std::size_t trials_ = 0;
  double trials_per_s_ = 0;
  Clock::time_point started_ = Clock::now();
};

}  // namespace

int run_search(const Problem& problem, const RunOptions& options) {
  return Search(problem, options).run();
}

}  // namespace scarab::search
