#include "services/supervisor/core/signals.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::supervisor {

double update(ExponentialMean& mean, double sample, double smoothing) {
  if (std::isfinite(sample)) {
    mean.value += smoothing * (sample - mean.value);
  }
  return mean.value;
}

void push(MovingWindow& window, double sample) {
  if (!std::isfinite(sample)) {
    return;
  }
  const auto places = static_cast<std::uint32_t>(window.sample.size());
  window.sample[window.next] = sample;
  window.next = (window.next + 1) % places;
  window.count = std::min(window.count + 1, places);
}

double mean(const MovingWindow& window, double width) {
  const std::size_t places = window.sample.size();
  double sum = 0;
  double weight_left = std::min(width, static_cast<double>(window.count));
  const double total = weight_left;
  for (std::size_t age = 1; weight_left > 0; ++age) {
    const double weight = std::min(1.0, weight_left);
    sum += weight * window.sample[(window.next + places - age) % places];
    weight_left -= weight;
  }
  return total > 0 ? sum / total : 0;
}

bool covers(const MovingWindow& window, double width) {
  return static_cast<double>(window.count) >= width;
}

}  // namespace scarab::supervisor
