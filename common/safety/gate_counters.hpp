#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/safety/verdict.hpp"

namespace scarab::safety {

/// What the gate changed in a command; counted once for each joint and tick.
enum class Clamp {
  kRange,   ///< outside the joint's range
  kTorque,  ///< would ask the servo for more than its torque limit
  kWindow,  ///< further from the previous target than the joint may turn in a tick
};

inline constexpr std::size_t kClampCount = 3;

/// As shown in service_status, in the order of Clamp.
inline constexpr std::array<std::string_view, kClampCount> kClampNames = {
    "targets_clamped_range", "targets_clamped_torque", "targets_clamped_window"};

/// Counts since the gate was made.
struct GateCounters {
  std::array<std::uint64_t, kOutcomeCount> outcomes{};  ///< by Outcome
  std::array<std::uint64_t, kClampCount> clamps{};      ///< by Clamp
  std::uint64_t safe_stops = 0;                         ///< times a safe stop began

  [[nodiscard]] std::uint64_t of(Outcome outcome) const {
    return outcomes[static_cast<std::size_t>(outcome)];
  }
  [[nodiscard]] std::uint64_t of(Clamp clamp) const {
    return clamps[static_cast<std::size_t>(clamp)];
  }
  /// All of them with their names, for service_status.
  [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> named() const;
};

}  // namespace scarab::safety
