#include "tests/unit/supervisor/scripted_robot.hpp"

#include "services/supervisor/config.hpp"

namespace scarab::supervisor {

SupervisorConfig shipped_config() {
  return load_config(SCARAB_SOURCE_DIR "/config/supervisor/beetle.yaml");
}

SupervisorConfig f2_config() {
  SupervisorConfig config = shipped_config();
  config.bs = {0.2, 0.15, 6};
  config.as = {14.43, 1.013, 0.062, 3, 30};
  config.backbone_rad = 0.05;
  return config;
}

ScriptedRobot::ScriptedRobot(const std::string& strategy, const SupervisorConfig& config)
    : front_f_rad(config.as.reference_rad),
      machine(config, find_strategy(config, strategy)),
      state(machine.initial_state()) {}

std::string ScriptedRobot::tell(const OperatorWord& word) {
  return machine.tell(state, word, tick_);
}

Decision ScriptedRobot::tick() {
  Perception perception;
  perception.tick = tick_++;
  perception.phase = phase;
  perception.pitch_rad = pitch_rad;
  perception.front_f_rad = {front_f_rad, front_f_rad};
  perception.supply_current_a = supply_current_a;
  perception.front_foot_n = {front_foot_n, front_foot_n};
  perception.measured = measured;
  return machine.step(state, perception);
}

Decision ScriptedRobot::ticks(int count) {
  Decision decision;
  for (int i = 0; i < count; ++i) {
    decision = tick();
  }
  return decision;
}

Decision ScriptedRobot::until(State wanted, int limit) {
  Decision decision;
  for (int i = 0; i < limit && (i == 0 || decision.state != wanted); ++i) {
    decision = tick();
  }
  return decision;
}

ScriptedRobot on_the_object(const std::string& strategy, const SupervisorConfig& config) {
  ScriptedRobot robot(strategy, config);
  robot.pitch_rad = 0.18;
  robot.until(State::kMode1);
  return robot;
}

OperatorWord mode_word(Mode mode) {
  OperatorWord word;
  word.command = OperatorWord::Command::kMode;
  word.mode = mode;
  return word;
}

OperatorWord inputs_word(const std::array<double, 4>& inputs) {
  OperatorWord word;
  word.command = OperatorWord::Command::kInputs;
  word.inputs = inputs;
  return word;
}

OperatorWord strategy_word(const std::string& strategy) {
  OperatorWord word;
  word.command = OperatorWord::Command::kStrategy;
  word.strategy = strategy;
  return word;
}

std::string reason(const Decision& decision) { return decision.reason.data(); }

}  // namespace scarab::supervisor
