#pragma once

#include <limits>
#include <string>

namespace scarab::config {

/// Accepted interval of a number, or of every number of a list: [min, max], or (min, max] if
/// above_min.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;

  [[nodiscard]] constexpr bool contains(double value) const {
    return (above_min ? value > min : value >= min) && value <= max;
  }
};

inline constexpr Range kAny{};
inline constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range kNonNegative{0.0, std::numeric_limits<double>::infinity()};
inline constexpr Range kFraction{0.0, 1.0};

/// In words: "in [0, 1]", "at least 0", "above 0".
[[nodiscard]] std::string describe(const Range& range);

}  // namespace scarab::config
