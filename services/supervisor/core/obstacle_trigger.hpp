#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scarab::supervisor {

/// The signal that tells that the object has hit the obstacle: what switches from mode 1 to mode 2.
/// Values equal those of the IDL enumeration.
enum class Trigger : std::uint32_t { kNone, kFrontAngle, kSupplyCurrent, kFootForce };

/// Names in the order of the enumeration, as in configuration files.
inline constexpr std::array<std::string_view, 4> kTriggerNames = {"none", "front_angle",
                                                                  "supply_current", "foot_force"};

constexpr std::string_view name(Trigger trigger) {
  return kTriggerNames[static_cast<std::size_t>(trigger)];
}

/// What of the triggers' signals the robot measures. An angle that is commanded is none: it says
/// nothing of a load.
struct Measured {
  bool front_angle = false;     ///< the F-joints of both front legs
  bool supply_current = false;  ///< of the whole robot
  bool foot_force = false;      ///< of both front feet
};

/// The first of `preference` that is measured; kNone if there is none.
[[nodiscard]] Trigger first_measured(const std::vector<Trigger>& preference,
                                     const Measured& measured);

/// Such as "front_angle, supply_current".
[[nodiscard]] std::string list_of(const std::vector<Trigger>& triggers);

}  // namespace scarab::supervisor
