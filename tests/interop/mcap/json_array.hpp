#pragma once

#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

namespace scarab::test {

/// C numbers as JSON, with all their digits.
template <class Number, std::size_t Size>
std::string json_array(const Number (&numbers)[Size]) {
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << '[';
  for (std::size_t i = 0; i < Size; ++i) out << (i > 0 ? "," : "") << numbers[i];
  out << ']';
  return out.str();
}

}  // namespace scarab::test
