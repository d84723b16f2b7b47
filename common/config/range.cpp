#include "common/config/range.hpp"

#include "common/config/scalar.hpp"

namespace scarab::config {

std::string describe(const Range& range) {
  const bool bounded_below = range.min > kAny.min;
  const bool bounded_above = range.max < kAny.max;
  if (bounded_below && bounded_above) {
    return (range.above_min ? "in (" : "in [") + format_number(range.min) + ", " +
           format_number(range.max) + "]";
  }
  if (bounded_below) {
    return (range.above_min ? "above " : "at least ") + format_number(range.min);
  }
  return bounded_above ? "at most " + format_number(range.max) : "any number";
}

}  // namespace scarab::config
