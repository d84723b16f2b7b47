#pragma once

#include <string>
#include <vector>

#include "services/supervisor/core/behaviour_machine.hpp"

namespace scarab::supervisor {

/// config/supervisor/beetle.yaml as it stands.
SupervisorConfig shipped_config();

/// The same with the triggers and the backbone of parameter set F2: the figures these tests
/// calculate with, whatever a search has found since.
SupervisorConfig f2_config();

/// A machine with its state, fed tick by tick with what a robot would measure.
class ScriptedRobot {
 public:
  explicit ScriptedRobot(const std::string& strategy, const SupervisorConfig& config = f2_config());

  double pitch_rad = 0;
  double front_f_rad = 0;  ///< starts at the reference angle: both front legs hold their target
  double supply_current_a = 0;
  double front_foot_n = 0;
  Measured measured{true, true, true};
  Phase phase = Phase::kRunning;

  /// The operator says this before the next tick; returns why it is refused.
  [[nodiscard]] std::string tell(const OperatorWord& word);
  /// One tick; returns its decision.
  Decision tick();
  /// `count` ticks; returns the last decision.
  Decision ticks(int count);
  /// Ticks until the machine is in `wanted`, at most `limit`; returns the decision that says so, or
  /// the last one.
  Decision until(State wanted, int limit = 200);
  /// The ticks of the next decision.
  [[nodiscard]] std::uint32_t next_tick() const { return tick_; }

  BehaviourMachine machine;
  MachineState state;

 private:
  std::uint32_t tick_ = 0;
};

/// A robot that has climbed and is in mode 1.
ScriptedRobot on_the_object(const std::string& strategy,
                            const SupervisorConfig& config = f2_config());

OperatorWord mode_word(Mode mode);
OperatorWord inputs_word(const std::array<double, 4>& inputs);
OperatorWord strategy_word(const std::string& strategy);

std::string reason(const Decision& decision);

}  // namespace scarab::supervisor
