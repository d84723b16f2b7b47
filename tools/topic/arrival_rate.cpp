#include "tools/topic/arrival_rate.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::topic {

ArrivalRate::ArrivalRate(double least_hz)
    : least_hz_(least_hz),
      intervals_(std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(least_hz)))) {}

void ArrivalRate::add(std::int64_t arrival_ns) {
  arrivals_ns_.push_back(arrival_ns);
  if (arrivals_ns_.size() > intervals_ + 1) arrivals_ns_.pop_front();
}

double ArrivalRate::rate_hz() const {
  if (arrivals_ns_.size() < 2) return 0.0;
  const double elapsed_s = static_cast<double>(arrivals_ns_.back() - arrivals_ns_.front()) * 1e-9;
  return static_cast<double>(arrivals_ns_.size() - 1) / std::max(elapsed_s, 1e-9);
}

bool ArrivalRate::reached() const {
  constexpr double kTolerance = 0.01;
  return arrivals_ns_.size() == intervals_ + 1 && rate_hz() >= least_hz_ * (1.0 - kTolerance);
}

}  // namespace scarab::topic
