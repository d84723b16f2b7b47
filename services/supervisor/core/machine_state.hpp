#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "services/supervisor/core/signals.hpp"

namespace scarab::supervisor {

/// Where the machine stands. Values equal those of the IDL enumeration.
enum class State { kIdle, kApproach, kClimb, kMode1, kMode2, kDone, kFailed, kSafeStop, kManual };

/// Zero-terminated; as long as the IDL's string.
using Reason = std::array<char, 128>;

/// All that the machine remembers between ticks. Trivially copyable: it is written to disk as it
/// is.
struct MachineState {
  State state = State::kIdle;
  std::uint32_t entered_tick = 0;  ///< tick at which `state` was entered
  Reason reason{};                 ///< why it was
  ExponentialMean bs;              ///< of the rear pitch, rad
  std::uint32_t bs_above = 0;      ///< consecutive ticks with BS over its threshold, of a climb
  std::uint32_t as_below =
      0;                 ///< consecutive ticks with AS under its threshold, of an armed mode 1
  MovingWindow front_f;  ///< mean angle of the two front F-joints, rad
};

static_assert(std::is_trivially_copyable_v<MachineState>);

}  // namespace scarab::supervisor
