#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace scarab::runtime {

/// How often a duration was how long: counts between fixed edges, so that histograms of any two
/// services or runs can be added up. scarab_Histogram on scarab/service_status is the same.
class Histogram {
 public:
  /// Upper edges (s) of all buckets but the last, which has none: 1, 2, 5 times the powers of ten
  /// from 1 us to 10 s.
  static constexpr std::array<double, 22> kEdgesS = {1e-6, 2e-6, 5e-6, 1e-5, 2e-5, 5e-5, 1e-4, 2e-4,
                                                     5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 1e-1,
                                                     2e-1, 5e-1, 1e0,  2e0,  5e0,  1e1};
  static constexpr std::size_t kBuckets = kEdgesS.size() + 1;
  using Counts = std::array<std::uint64_t, kBuckets>;

  Histogram() = default;
  Histogram(const Counts& counts, double sum_s, double max_s)
      : counts_(counts), sum_s_(sum_s), max_s_(max_s) {}

  /// A negative duration counts as 0.
  void add(std::chrono::nanoseconds duration);

  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] double sum_s() const { return sum_s_; }
  [[nodiscard]] double max_s() const { return max_s_; }
  [[nodiscard]] std::uint64_t total() const;
  /// An upper bound (s) of the smallest `share` (0 to 1) of all durations: the edge of the bucket
  /// they end in, or the longest there was where that is less. 0 without any.
  [[nodiscard]] double quantile_s(double share) const;

 private:
  Counts counts_{};
  double sum_s_ = 0;
  double max_s_ = 0;
};

}  // namespace scarab::runtime
