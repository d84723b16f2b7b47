#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "services/supervisor/core/machine_state.hpp"
#include "services/supervisor/core/operator_word.hpp"
#include "services/supervisor/core/strategy.hpp"
#include "services/supervisor/core/supervisor_config.hpp"

namespace scarab::supervisor {

/// How the trial stands, as the tick master announces it. Values equal those of the IDL
/// enumeration.
enum class Phase { kRunning, kSafeStop, kHoming, kSucceeded, kFailed };

/// What the supervisor takes from robot_state: only what a real robot measures.
struct Perception {
  std::uint32_t tick = 0;
  Phase phase = Phase::kRunning;
  double pitch_rad = 0;                 ///< of the rear trunk, + = rear up
  std::array<double, 2> front_f_rad{};  ///< F-joint angles of the left and right front leg
  double supply_current_a = 0;
  std::array<double, 2> front_foot_n{};  ///< normal force on the left and right front foot
  Measured measured;                     ///< which of the last three are measured
};

/// What the machine says for one tick (adapter: scarab/behaviour).
struct Decision {
  Mode mode = Mode::kStop;
  std::array<double, 4> inputs{};  ///< I1..I4
  bool hind_override = false;
  std::array<double, 3> hind_pose_rad{};  ///< T, C, F
  double backbone_rad = 0;
  State state = State::kIdle;
  std::uint32_t entered_tick = 0;
  Reason reason{};  ///< zero-terminated
  double bs_rad = 0;
  double bs_threshold_rad = 0;
  double as_rad = 0;
  double as_threshold_rad = 0;
  Trigger trigger = Trigger::kNone;
  double trigger_value = 0;  ///< rad, A or N
  double trigger_threshold = 0;
};

/// The behaviour machine of the paper (section 3): pure function from (state, perception) to
/// (state, decision).
///
///     idle -> approach <-> climb -> mode 1 -> mode 2
///     any of them -> done, failed: as the phase says, for good
///     any of them -> safe stop -> approach
///     any of them -> manual -> approach: as the operator says
///
/// approach -> climb: BS over its threshold. climb -> mode 1: BS over it for settle_ticks on end
/// ("after a certain time step"); -> approach: BS fell back. mode 1 -> mode 2: the trigger's signal
/// (AS, where the joints' angles are measured) beyond its threshold for confirm_ticks on end,
/// counted from arm_ticks after mode 1 began. The trigger is the first of the strategy's list that
/// the robot measures at the trial's first running tick; without one there is no mode 2. After a
/// safe stop the machine approaches again, whatever it did before: the robot has been homed, and if
/// it still lies on the object BS will say so.
///
/// An operator may hold the robot to a mode or to inputs (manual), or have it follow another
/// strategy, from its approach on. The end of the trial, a safe stop and homing come before that:
/// what the operator said then counts from when they are over. A new state has forgotten it all.
class BehaviourMachine {
 public:
  /// Throws std::invalid_argument, naming the value, for parameters outside the ranges given in
  /// supervisor_config.hpp.
  BehaviourMachine(SupervisorConfig config, Strategy strategy);

  [[nodiscard]] MachineState initial_state() const;

  /// Takes an operator's word for the step of `tick`, which comes next. Returns why it is refused,
  /// and nothing has changed; empty: it is taken.
  [[nodiscard]] std::string tell(MachineState& state, const OperatorWord& word,
                                 std::uint32_t tick) const;

  /// Advances `state` by one tick and returns the decision for it. At most one transition a tick.
  [[nodiscard]] Decision step(MachineState& state, const Perception& perception) const;

  /// What keeps the strategy from being followed to its end, a sentence; empty: nothing.
  [[nodiscard]] std::string complaint(const MachineState& state) const;

 private:
  void advance(MachineState& state, const Perception& perception) const;
  void advance_running(MachineState& state, const Perception& perception) const;
  void choose_trigger(MachineState& state) const;
  void approach(MachineState& state, std::uint32_t tick) const;
  void climb(MachineState& state, std::uint32_t tick) const;
  void watch_for_obstacle(MachineState& state, std::uint32_t tick) const;
  [[nodiscard]] const Strategy& strategy_of(const MachineState& state) const;
  [[nodiscard]] Mode mode_of(const MachineState& state) const;

  SupervisorConfig config_;
  Strategy strategy_;  // of the trial
};

}  // namespace scarab::supervisor
