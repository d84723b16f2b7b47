#pragma once

#include <string>
#include <vector>

namespace scarab::search {

/// One number that is searched for.
struct Parameter {
  std::string path;
  double low = 0;
  double high = 0;
  double start = 0;  ///< within [low, high]
};

/// Folds any number back into [0, 1] as two facing mirrors would: 1.2 becomes 0.8, -0.3 becomes
/// 0.3. So the optimiser knows no bounds, and near one its distribution is not piled up on it.
[[nodiscard]] double fold(double x);

/// Values as the optimiser sees them (any real number, [0, 1] being the interval) to values as the
/// configuration has them and back. The latter are rounded to 1/2000 of the interval or finer, to
/// a round decimal, so that what is written into a file is exactly what was tried.
class ParameterSpace {
 public:
  explicit ParameterSpace(std::vector<Parameter> parameters);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  [[nodiscard]] std::vector<double> start_point() const;
  [[nodiscard]] std::vector<double> values(const std::vector<double>& point) const;

 private:
  std::vector<Parameter> parameters_;
};

}  // namespace scarab::search
