#include "tools/topic/quantity.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace scarab::topic {

std::string fixed(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }

std::string rounded(double value) {
  const double size = std::abs(value);
  if (!std::isfinite(value) || size >= 100.0) return fixed(value, 0);
  if (size >= 10.0) return fixed(value, 1);
  if (size >= 0.9995 || size == 0.0) return fixed(value, 2);
  return fmt::format("{:.3g}", value);
}

std::string seconds_text(double seconds) { return fmt::format("{:g} s", seconds); }

std::string bytes_text(double bytes) {
  constexpr std::array<const char*, 5> kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (std::abs(bytes) >= 999.5 && unit + 1 < kUnits.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  return (unit == 0 ? fixed(bytes, 0) : rounded(bytes)) + " " + kUnits[unit];
}

std::string counted(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace scarab::topic
