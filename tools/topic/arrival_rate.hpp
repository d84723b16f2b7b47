#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

namespace scarab::topic {

/// Tells as soon as samples arrive often enough: over a second, or over 3 samples where that is
/// longer.
class ArrivalRate {
 public:
  explicit ArrivalRate(double least_hz);

  void add(std::int64_t arrival_ns);
  /// Of the last arrivals; 0 before there are enough of them.
  double rate_hz() const;
  /// With a tolerance of 1 %, so that a writer of just that rate does.
  bool reached() const;

 private:
  double least_hz_;
  std::size_t intervals_;  ///< to look back
  std::deque<std::int64_t> arrivals_ns_;
};

}  // namespace scarab::topic
