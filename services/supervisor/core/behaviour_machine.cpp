#include "services/supervisor/core/behaviour_machine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace scarab::supervisor {
namespace {

void require(bool condition, const char* what) {
  if (!condition) {
    throw std::invalid_argument(what);
  }
}

void check(const SupplyCurrentConfig& current) {
  require(std::isfinite(current.reference_a), "supply_current.reference_a is not finite");
  require(std::isfinite(current.rise_a), "supply_current.rise_a is not finite");
  require(current.confirm_ticks >= 1, "supply_current.confirm_ticks is not at least 1");
}

void check(const FootForceConfig& force) {
  require(std::isfinite(force.reference_n), "foot_force.reference_n is not finite");
  require(std::isfinite(force.rise_n), "foot_force.rise_n is not finite");
  require(force.confirm_ticks >= 1, "foot_force.confirm_ticks is not at least 1");
}

void check(const SupervisorConfig& config, const Strategy& strategy) {
  const InclinationConfig& bs = config.bs;
  const FrontAngleConfig& as = config.as;
  require(bs.smoothing > 0 && bs.smoothing <= 1, "bs.smoothing is not in (0, 1]");
  require(std::isfinite(bs.threshold_rad), "bs.threshold_rad is not finite");
  require(bs.settle_ticks >= 2, "bs.settle_ticks is not at least 2");
  require(as.window_ticks >= 1 && as.window_ticks <= static_cast<double>(kMaxWindowTicks),
          "as.window_ticks is not in 1..64");
  require(std::isfinite(as.reference_rad), "as.reference_rad is not finite");
  require(std::isfinite(as.drop_rad), "as.drop_rad is not finite");
  require(as.confirm_ticks >= 1, "as.confirm_ticks is not at least 1");
  check(config.supply_current);
  check(config.foot_force);
  require(std::isfinite(config.backbone_rad), "backbone_rad is not finite");
  require(strategy.push.size() <= 2, "a strategy has more than two pushing modes");
}

/// A number of a reason, to 3 decimals.
std::string figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", value);
  return text.data();
}

std::string figure_ticks(std::uint32_t ticks) {
  return std::to_string(ticks) + (ticks == 1 ? " tick" : " ticks");
}

bool is_final(State state) { return state == State::kDone || state == State::kFailed; }

/// Enters the safe stop, or goes on in it for another reason.
void hold_still(MachineState& machine, std::uint32_t tick, const std::string& reason) {
  if (machine.state == State::kSafeStop && reason == machine.reason.data()) return;
  enter(machine, State::kSafeStop, tick, reason);
}

/// What the machine does where nothing keeps it from it: what the operator holds it to, else
/// approach.
void begin_running(MachineState& machine, std::uint32_t tick, const std::string& reason) {
  if (is_manual(machine)) {
    enter(machine, State::kManual, tick, reason + "; operator: " + phrase(machine.manual));
  } else {
    enter(machine, State::kApproach, tick, reason);
  }
}

}  // namespace

BehaviourMachine::BehaviourMachine(SupervisorConfig config, Strategy strategy)
    : config_(std::move(config)), strategy_(std::move(strategy)) {
  check(config_, strategy_);
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): of this machine, like step()
MachineState BehaviourMachine::initial_state() const {
  MachineState machine;
  enter(machine, State::kIdle, 0, "before the first tick");
  return machine;
}

std::string BehaviourMachine::tell(MachineState& state, const OperatorWord& word,
                                   std::uint32_t tick) const {
  using Command = OperatorWord::Command;
  if (is_final(state.state)) return "the trial has ended";
  std::string refused = refusal(word, config_);
  if (!refused.empty()) return refused;
  switch (word.command) {
    case Command::kAutomatic:
      if (!is_manual(state)) return "";
      state.manual = {};
      break;
    case Command::kStrategy:
      state.manual = {};
      choose_strategy(state, word.strategy);
      if (state.began) choose_trigger(state);
      break;
    case Command::kMode:
      state.manual = {Manual::Hold::kMode, word.mode, {}};
      break;
    case Command::kInputs:
      state.manual = {Manual::Hold::kInputs, nearest_mode(config_, word.inputs), word.inputs};
      break;
  }
  if (state.state == State::kIdle || state.state == State::kSafeStop) return "";
  const std::string said = is_manual(state) ? phrase(state.manual) : standing(state);
  enter(state, is_manual(state) ? State::kManual : State::kApproach, tick,
        "operator: " + said + (word.reason.empty() ? "" : ": " + word.reason));
  return "";
}

Decision BehaviourMachine::step(MachineState& state, const Perception& perception) const {
  update(state.bs, perception.pitch_rad, config_.bs.smoothing);
  push(state.signals.front_f_rad, (perception.front_f_rad[0] + perception.front_f_rad[1]) / 2);
  push(state.signals.supply_current_a, perception.supply_current_a);
  push(state.signals.front_foot_n, (perception.front_foot_n[0] + perception.front_foot_n[1]) / 2);
  advance(state, perception);

  Decision decision;
  decision.mode = mode_of(state);
  const bool by_hand = state.state == State::kManual && state.manual.hold == Manual::Hold::kInputs;
  decision.inputs = by_hand ? state.manual.inputs : inputs_of(config_, decision.mode);
  decision.hind_override = decision.mode == Mode::kStationary;
  if (decision.hind_override) {
    decision.hind_pose_rad = config_.stationary_hind_pose_rad;
  }
  decision.backbone_rad = config_.backbone_rad;
  decision.state = state.state;
  decision.entered_tick = state.entered_tick;
  decision.reason = state.reason;
  decision.bs_rad = state.bs.value;
  decision.bs_threshold_rad = config_.bs.threshold_rad;
  const ObstacleReading as = read(state.signals, config_, Trigger::kFrontAngle);
  decision.as_rad = as.value;
  decision.as_threshold_rad = as.threshold;
  const ObstacleReading trigger = read(state.signals, config_, state.trigger);
  decision.trigger = state.trigger;
  decision.trigger_value = trigger.value;
  decision.trigger_threshold = trigger.threshold;
  return decision;
}

std::string BehaviourMachine::complaint(const MachineState& state) const {
  const Strategy& strategy = strategy_of(state);
  const bool switches = strategy.push.size() == 2 && !is_manual(state);
  if (!state.began || !switches || state.trigger != Trigger::kNone) return "";
  return "there will be no mode 2: this robot measures none of the signals by which the strategy "
         "switches to it (" +
         list_of(strategy.obstacle) + ")";
}

void BehaviourMachine::advance(MachineState& state, const Perception& perception) const {
  if (is_final(state.state)) {
    return;
  }
  const std::uint32_t tick = perception.tick;
  switch (perception.phase) {
    case Phase::kSucceeded:
      return enter(state, State::kDone, tick, "the tick master announced success");
    case Phase::kFailed:
      return enter(state, State::kFailed, tick, "the tick master announced failure");
    case Phase::kSafeStop:
      return hold_still(state, tick, "the tick master announced a safe stop");
    case Phase::kHoming:
      return hold_still(state, tick, "homing");
    case Phase::kRunning:
      return advance_running(state, perception);
  }
}

void BehaviourMachine::choose_trigger(MachineState& state) const {
  const Strategy& strategy = strategy_of(state);
  state.trigger = strategy.push.size() == 2 ? first_measured(strategy.obstacle, state.measured)
                                            : Trigger::kNone;
}

void BehaviourMachine::advance_running(MachineState& state, const Perception& perception) const {
  const std::uint32_t tick = perception.tick;
  if (!state.began) {
    state.began = true;
    state.measured = perception.measured;
    choose_trigger(state);
  }
  switch (state.state) {
    case State::kIdle:
      return begin_running(state, tick, "the trial runs");
    case State::kSafeStop:
      return begin_running(state, tick, "the safe stop has ended");
    case State::kApproach:
      return approach(state, tick);
    case State::kClimb:
      return climb(state, tick);
    case State::kMode1:
      return watch_for_obstacle(state, tick);
    case State::kMode2:
    case State::kManual:
    case State::kDone:
    case State::kFailed:
      return;
  }
}

void BehaviourMachine::approach(MachineState& state, std::uint32_t tick) const {
  const bool just_told = state.entered_tick == tick;  // else a step finds states of earlier ticks
  if (just_told || strategy_of(state).push.empty() ||
      !(state.bs.value > config_.bs.threshold_rad)) {
    return;
  }
  enter(state, State::kClimb, tick,
        "BS " + figure(state.bs.value) + " > " + figure(config_.bs.threshold_rad) + " rad");
  state.bs_above = 1;
}

void BehaviourMachine::climb(MachineState& state, std::uint32_t tick) const {
  const std::string bs = "BS " + figure(state.bs.value);
  const std::string threshold = figure(config_.bs.threshold_rad) + " rad";
  if (!(state.bs.value > config_.bs.threshold_rad)) {
    enter(state, State::kApproach, tick, bs + " fell back to <= " + threshold);
    return;
  }
  ++state.bs_above;
  if (state.bs_above >= config_.bs.settle_ticks) {
    enter(state, State::kMode1, tick,
          bs + " > " + threshold + " for " + figure_ticks(state.bs_above));
  }
}

void BehaviourMachine::watch_for_obstacle(MachineState& state, std::uint32_t tick) const {
  const ObstacleTiming timing = timing_of(config_, state.trigger);
  const bool armed = tick - state.entered_tick >= timing.arm_ticks;
  if (state.trigger == Trigger::kNone || !armed) return;
  const ObstacleReading reading = read(state.signals, config_, state.trigger);
  state.beyond = reading.beyond ? state.beyond + 1 : 0;
  if (state.beyond >= timing.confirm_ticks) {
    enter(state, State::kMode2, tick,
          phrase(reading, state.trigger) + " for " + figure_ticks(state.beyond));
  }
}

const Strategy& BehaviourMachine::strategy_of(const MachineState& state) const {
  const std::string chosen = state.strategy.data();
  return chosen.empty() ? strategy_ : find_strategy(config_, chosen);
}

Mode BehaviourMachine::mode_of(const MachineState& state) const {
  switch (state.state) {
    case State::kApproach:
    case State::kClimb:
      return strategy_of(state).approach;
    case State::kMode1:
      return strategy_of(state).push.at(0);
    case State::kMode2:
      return strategy_of(state).push.at(1);
    case State::kManual:
      return state.manual.mode;
    case State::kIdle:
    case State::kDone:
    case State::kFailed:
    case State::kSafeStop:
      return Mode::kStop;
  }
  throw std::invalid_argument("no such state");
}

}  // namespace scarab::supervisor
