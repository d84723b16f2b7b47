#pragma once

#include <cstdint>
#include <limits>

namespace scarab::topic {

/// Count, mean, spread and extremes of numbers, added one by one or from another set (Chan, Golub
/// and LeVeque 1983).
class Moments {
 public:
  void add(double value);
  void add(const Moments& other);

  std::uint64_t count() const { return count_; }
  /// Nan while there is none; so are the others.
  double mean() const { return count_ == 0 ? kNan : mean_; }
  double min() const { return count_ == 0 ? kNan : min_; }
  double max() const { return count_ == 0 ? kNan : max_; }
  /// Of the numbers as they are (divided by their count); 0 for a single one.
  double standard_deviation() const;

 private:
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

  std::uint64_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  ///< of the differences from the mean
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
};

}  // namespace scarab::topic
