#include "tools/search/parameter_space.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::search {
namespace {

constexpr double kShareOfInterval = 2000;

double rounded(const Parameter& parameter, double value) {
  const double most = (parameter.high - parameter.low) / kShareOfInterval;
  // Divided, not multiplied by a power below 1: 0.1234 then is the number nearest to 0.1234.
  const double per_unit = std::pow(10.0, std::ceil(-std::log10(most)));
  return std::clamp(std::round(value * per_unit) / per_unit, parameter.low, parameter.high);
}

}  // namespace

double fold(double x) {
  const double within = std::fmod(std::abs(x), 2.0);
  return within <= 1 ? within : 2 - within;
}

ParameterSpace::ParameterSpace(std::vector<Parameter> parameters)
    : parameters_(std::move(parameters)) {}

std::vector<double> ParameterSpace::start_point() const {
  std::vector<double> point;
  for (const Parameter& p : parameters_) point.push_back((p.start - p.low) / (p.high - p.low));
  return point;
}

std::vector<double> ParameterSpace::values(const std::vector<double>& point) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& p = parameters_[i];
    values.push_back(rounded(p, p.low + fold(point.at(i)) * (p.high - p.low)));
  }
  return values;
}

}  // namespace scarab::search
