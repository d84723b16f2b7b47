#include "common/config/unit.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace scarab::config {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 22> kUnits = {{
    {"_m", "m"},
    {"_m_s", "m/s"},
    {"_m_s2", "m/s^2"},
    {"_rad", "rad"},
    {"_rad_s", "rad/s"},
    {"_rad_s2", "rad/s^2"},
    {"_kg", "kg"},
    {"_kg_m2", "kg m^2"},
    {"_n", "N"},
    {"_nm", "N m"},
    {"_n_m", "N/m"},
    {"_n_s_m", "N s/m"},
    {"_nm_rad", "N m/rad"},
    {"_nm_s_rad", "N m s/rad"},
    {"_a", "A"},
    {"_nm_a", "N m/A"},
    {"_s", "s"},
    {"_ns", "ns"},
    {"_hz", "Hz"},
    {"_ticks", "ticks"},
    {"_kib", "KiB"},
    {"_mib", "MiB"},
}};

/// Words that are part of a unit wherever they stand: `walk_rad_s_s` is not in seconds.
constexpr std::array<std::string_view, 11> kParts = {"m",  "s",  "rad",  "kg",  "n", "a",
                                                     "nm", "hz", "sqrt", "per", "s2"};

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

}  // namespace

std::string_view unit_of(std::string_view key) {
  std::pair<std::string_view, std::string_view> longest;
  for (const auto& unit : kUnits) {
    if (ends_with(key, unit.first) && unit.first.size() > longest.first.size()) longest = unit;
  }
  const std::string_view rest = key.substr(0, key.size() - longest.first.size());
  const std::string_view before = rest.substr(rest.rfind('_') + 1);  // all of it if there is none
  const bool cut = std::find(kParts.begin(), kParts.end(), before) != kParts.end();
  return cut ? std::string_view{} : longest.second;
}

}  // namespace scarab::config
