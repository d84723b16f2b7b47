#include "tools/search/cma_es.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <stdexcept>

namespace scarab::search {
namespace {

using Point = CmaEs::Point;

/// What pagmo takes for the problem: notes the points it is asked about, in order, and answers with
/// the costs it was given, in order; with 0 if it was given none.
struct Correspondent {
  std::size_t dimension = 1;
  std::shared_ptr<std::vector<Point>> asked;
  std::shared_ptr<const std::vector<double>> costs;

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& point) const {
    const std::size_t index = asked->size();
    asked->push_back(point);
    return {costs ? costs->at(index) : 0.0};
  }
  // Of width 1, by which pagmo scales its first deviation. Nothing is held within: fold() does.
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {pagmo::vector_double(dimension, 0.0), pagmo::vector_double(dimension, 1.0)};
  }
};

/// Weighted mean of the better half with the weights of CMA-ES.
Point recombine(const std::vector<Point>& points, const std::vector<double>& costs) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  const std::size_t parents = points.size() / 2;
  Point mean(points[0].size(), 0.0);
  double sum = 0;
  for (std::size_t i = 0; i < parents; ++i) {
    const double weight =
        std::log(static_cast<double>(parents) + 0.5) - std::log(static_cast<double>(i + 1));
    sum += weight;
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += weight * points[order[i]][k];
  }
  for (double& x : mean) x /= sum;
  return mean;
}

}  // namespace

struct CmaEs::State {
  pagmo::cmaes algorithm;
  pagmo::vector_double start;
  unsigned population;
  std::vector<Point> candidates;
  Point mean;

  /// One generation of `evolver`; what it asked for.
  [[nodiscard]] std::vector<Point> evolve(const pagmo::cmaes& evolver,
                                          std::shared_ptr<const std::vector<double>> costs) const {
    auto asked = std::make_shared<std::vector<Point>>();
    const Correspondent correspondent{start.size(), asked, std::move(costs)};
    // pagmo begins at the best individual; afterwards it goes by its own memory alone.
    pagmo::population individuals{pagmo::problem(correspondent), 0U, 0U};
    for (unsigned i = 0; i < population; ++i) individuals.push_back(start, {0.0});
    evolver.evolve(individuals);
    return std::move(*asked);
  }
  void rehearse() {
    const pagmo::cmaes copy = algorithm;  // with its memory and its random numbers
    candidates = evolve(copy, nullptr);
  }
};

CmaEs::CmaEs(const Point& start, double sigma, unsigned population, std::uint32_t seed) {
  if (population < 5) throw std::invalid_argument("CMA-ES needs at least 5 candidates");
  constexpr double kAutomatic = -1;
  constexpr double kNever = 0;  // it does not end by itself: that is for who looks at the course
  constexpr bool kMemory = true;
  constexpr bool kForceBounds = false;
  state_ = std::make_unique<State>(
      State{pagmo::cmaes(1U, kAutomatic, kAutomatic, kAutomatic, kAutomatic, sigma, kNever, kNever,
                         kMemory, kForceBounds, seed),
            start,
            population,
            {},
            start});
  state_->rehearse();
}

CmaEs::~CmaEs() = default;
CmaEs::CmaEs(CmaEs&& other) noexcept = default;
CmaEs& CmaEs::operator=(CmaEs&& other) noexcept = default;

const std::vector<Point>& CmaEs::ask() const { return state_->candidates; }

void CmaEs::tell(const std::vector<double>& costs) {
  const bool finite =
      std::all_of(costs.begin(), costs.end(), [](double cost) { return std::isfinite(cost); });
  if (costs.size() != state_->candidates.size() || !finite) {
    throw std::invalid_argument("CMA-ES needs one finite cost a candidate");
  }
  const auto drawn =
      state_->evolve(state_->algorithm, std::make_shared<const std::vector<double>>(costs));
  if (drawn != state_->candidates) throw std::logic_error("pagmo drew other candidates");
  state_->mean = recombine(state_->candidates, costs);
  state_->rehearse();
}

const Point& CmaEs::mean() const { return state_->mean; }

double CmaEs::spread() const {
  const auto& points = state_->candidates;
  const auto count = static_cast<double>(points.size());
  double sum = 0;
  for (std::size_t k = 0; k < points[0].size(); ++k) {
    double first = 0;
    double second = 0;
    for (const Point& point : points) first += point[k] / count;
    for (const Point& point : points) second += std::pow(point[k] - first, 2) / (count - 1);
    sum += second;
  }
  return std::sqrt(sum / static_cast<double>(points[0].size()));
}

}  // namespace scarab::search
