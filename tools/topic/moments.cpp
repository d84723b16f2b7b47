#include "tools/topic/moments.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::topic {

void Moments::add(double value) {
  ++count_;
  const double before = value - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (value - mean_);
  min_ = std::min(min_, value);
  max_ = std::max(max_, value);
}

void Moments::add(const Moments& other) {
  if (other.count_ == 0) return;
  const auto total = static_cast<double>(count_ + other.count_);
  const double difference = other.mean_ - mean_;
  const double share = static_cast<double>(other.count_) / total;
  squares_ += other.squares_ + difference * difference * static_cast<double>(count_) * share;
  mean_ += difference * share;
  count_ += other.count_;
  min_ = std::min(min_, other.min_);
  max_ = std::max(max_, other.max_);
}

double Moments::standard_deviation() const {
  return count_ == 0 ? kNan : std::sqrt(squares_ / static_cast<double>(count_));
}

}  // namespace scarab::topic
