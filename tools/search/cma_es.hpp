#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace scarab::search {

/// CMA-ES of pagmo (N. Hansen, "The CMA evolution strategy: a comparing review", 2006), one
/// generation at a time: ask() for the candidates, tell() what each costs. Costs are compared
/// within a generation only, so they may come from other trials in the next.
///
/// pagmo itself evaluates inside of evolve(), one candidate after the other. Here evolve() is
/// called twice: on a copy, which shows the candidates it draws, and, once their costs are known,
/// on the original, which draws the same ones. So trials of a whole generation can be run side by
/// side. The sequence is a pure function of the constructor's arguments and the costs told: a
/// search goes on after an interruption by being told again what it was told.
class CmaEs {
 public:
  using Point = std::vector<double>;

  /// Begins around `start` with standard deviation `sigma` in every direction. Throws
  /// std::invalid_argument for fewer than 5 candidates.
  CmaEs(const Point& start, double sigma, unsigned population, std::uint32_t seed);
  ~CmaEs();
  CmaEs(CmaEs&& other) noexcept;
  CmaEs& operator=(CmaEs&& other) noexcept;

  /// The candidates of the generation; the same until tell() is called.
  [[nodiscard]] const std::vector<Point>& ask() const;
  /// Ends the generation. `costs` in the order of ask(), finite. Throws std::invalid_argument.
  void tell(const std::vector<double>& costs);

  /// Middle of the distribution: before the first tell() the start, then the weighted mean of the
  /// better half of the last generation, as CMA-ES recombines it.
  [[nodiscard]] const Point& mean() const;
  /// Standard deviation of the candidates of ask() about their average, root mean square over all
  /// coordinates.
  [[nodiscard]] double spread() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scarab::search
