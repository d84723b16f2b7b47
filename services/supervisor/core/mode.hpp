#pragma once

#include <array>
#include <string_view>

namespace scarab::supervisor {

/// The motor pattern asked of the premotor network (paper, Table 1; stop and stationary stand
/// beside it). Values equal those of the IDL enumeration.
enum class Mode { kStop, kForward, kBackward, kSoftPush, kBoxing, kStationary, kHardPush };

/// Names in the order of the enumeration, as in configuration files and reasons.
inline constexpr std::array<std::string_view, 7> kModeNames = {
    "stop", "forward", "backward", "soft_push", "boxing", "stationary", "hard_push"};

constexpr std::string_view name(Mode mode) { return kModeNames[static_cast<std::size_t>(mode)]; }

}  // namespace scarab::supervisor
