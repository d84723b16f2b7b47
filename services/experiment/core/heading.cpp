#include "services/experiment/core/heading.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::experiment {
namespace {

constexpr double kFullTurnRad = 2 * 3.141592653589793238462643;

}  // namespace

double heading_rad(const std::array<double, 4>& orientation_wxyz) {
  const auto& [w, x, y, z] = orientation_wxyz;
  return std::atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
}

/// Against the first sample and rounded to whole turns, so that no rounding adds up.
void Turn::see(double heading_rad) {
  if (!first_rad_) first_rad_ = heading_rad;
  const double within = heading_rad - *first_rad_;
  const double turns = std::round((turned_rad_ - within) / kFullTurnRad);
  turned_rad_ = within + turns * kFullTurnRad;
  most_rad_ = std::max(most_rad_, std::abs(turned_rad_));
}

}  // namespace scarab::experiment
