#include "common/runtime/histogram.hpp"

#include <algorithm>
#include <numeric>

namespace scarab::runtime {

void Histogram::add(std::chrono::nanoseconds duration) {
  const double s = std::max(0.0, std::chrono::duration<double>(duration).count());
  const auto* edge = std::upper_bound(kEdgesS.begin(), kEdgesS.end(), s);
  ++counts_[static_cast<std::size_t>(edge - kEdgesS.begin())];
  sum_s_ += s;
  max_s_ = std::max(max_s_, s);
}

std::uint64_t Histogram::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

double Histogram::quantile_s(double share) const {
  const double wanted = share * static_cast<double>(total());
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < kEdgesS.size(); ++i) {
    seen += counts_[i];
    if (seen > 0 && static_cast<double>(seen) >= wanted) return std::min(kEdgesS[i], max_s_);
  }
  return max_s_;
}

}  // namespace scarab::runtime
