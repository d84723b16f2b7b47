#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>

#include "services/supervisor/core/manual.hpp"
#include "services/supervisor/core/obstacle_watch.hpp"
#include "services/supervisor/core/signals.hpp"

namespace scarab::supervisor {

/// Where the machine stands. Values equal those of the IDL enumeration.
enum class State { kIdle, kApproach, kClimb, kMode1, kMode2, kDone, kFailed, kSafeStop, kManual };

/// Zero-terminated; each as long as the IDL's string.
using Reason = std::array<char, 128>;
using StrategyName = std::array<char, 64>;

/// All that the machine remembers between ticks. Trivially copyable: it is written to disk as it
/// is.
struct MachineState {
  State state = State::kIdle;
  std::uint32_t entered_tick = 0;  ///< tick at which `state` was entered
  Reason reason{};                 ///< why it was
  ExponentialMean bs;              ///< of the rear pitch, rad
  std::uint32_t bs_above = 0;      ///< consecutive ticks with BS over its threshold, of a climb
  std::uint32_t beyond = 0;  ///< consecutive ticks beyond the trigger's threshold, while armed
  ObstacleSignals signals;
  bool began = false;  ///< the trial has had a running tick; what follows was seen at the first
  Measured measured;
  Trigger trigger = Trigger::kNone;  ///< of the strategy that is followed
  Manual manual;                     ///< what the operator holds the robot to
  StrategyName strategy{};           ///< the one the operator chose; empty: the trial's
};

static_assert(std::is_trivially_copyable_v<MachineState>);

/// Goes over to `next` at `tick`; a reason that is too long is cut.
void enter(MachineState& machine, State next, std::uint32_t tick, const std::string& reason);

/// Follows the configured strategy of that name from now on.
void choose_strategy(MachineState& machine, const std::string& name);

[[nodiscard]] bool is_manual(const MachineState& machine);

/// What of the operator's words holds, such as "manual: mode forward" or "automatic: strategy
/// soft".
[[nodiscard]] std::string standing(const MachineState& machine);

}  // namespace scarab::supervisor
