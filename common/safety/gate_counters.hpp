#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "common/safety/verdict.hpp"

namespace scarab::safety {

/// What the gate had to change in accepted commands; counted once for each joint and tick.
enum class Clamp {
  kWindow,  ///< further from the previous target than the servo can turn in a tick
  kRange,   ///< outside the joint's range
  kTorque,  ///< would ask the servo for more than its torque limit
};

inline constexpr std::size_t kClampCount = 3;

/// As shown in service_status, in the order of Clamp.
inline constexpr std::array<std::string_view, kClampCount> kClampNames = {
    "clamped_window", "clamped_range", "clamped_torque"};

/// Counts since the gate was made.
struct GateCounters {
  std::array<std::uint64_t, kVerdictCount> verdicts{};  ///< by Verdict
  std::array<std::uint64_t, kClampCount> clamps{};      ///< by Clamp
  std::uint64_t safe_stops = 0;                         ///< times a safe stop began

  [[nodiscard]] std::uint64_t of(Verdict verdict) const {
    return verdicts[static_cast<std::size_t>(verdict)];
  }
  [[nodiscard]] std::uint64_t of(Clamp clamp) const {
    return clamps[static_cast<std::size_t>(clamp)];
  }
};

}  // namespace scarab::safety
