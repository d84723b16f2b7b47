#pragma once

#include <array>
#include <cstdint>

#include "services/supervisor/core/strategy.hpp"
#include "services/supervisor/core/supervisor_config.hpp"

namespace scarab::supervisor {

/// Values equal those of the IDL enumerations of the same names.
enum class Mode { kStop, kForward, kBackward, kSoftPush, kBoxing, kStationary, kHardPush };
enum class State { kIdle, kApproach, kClimb, kMode1, kMode2, kDone, kFailed, kSafeStop };
enum class Phase { kRunning, kSafeStop, kSucceeded, kFailed };

/// What the supervisor takes from robot_state: only what a real robot measures.
struct Perception {
  std::uint32_t tick = 0;
  Phase phase = Phase::kRunning;
  double pitch_rad = 0;                      ///< of the rear trunk, + = rear up
  std::array<double, 2> front_f_rad{};       ///< F-joint angles of the left and right front leg
};

/// All that the machine remembers between ticks. Trivially copyable: it is written to disk as it is.
struct MachineState;   // defined in machine_state.hpp

/// What the machine says for one tick (adapter: scarab/behaviour).
struct Decision {
  Mode mode = Mode::kStop;
  std::array<double, 4> inputs{};
  bool hind_override = false;
  std::array<double, 3> hind_pose_rad{};
  double backbone_rad = 0;
  State state = State::kIdle;
  std::uint32_t entered_tick = 0;
  std::array<char, 128> reason{};            ///< zero-terminated
  double bs_rad = 0, bs_threshold_rad = 0, as_rad = 0, as_threshold_rad = 0;
};

/// The behaviour machine of the paper (section 3): pure function from (state, perception) to (state, decision).
class BehaviourMachine {
 public:
  BehaviourMachine(const SupervisorConfig& config, const Strategy& strategy);
  [[nodiscard]] MachineState initial_state() const;
  /// Advances `state` by one tick and returns the decision for it.
  [[nodiscard]] Decision step(MachineState& state, const Perception& perception) const;
};

}  // namespace scarab::supervisor
