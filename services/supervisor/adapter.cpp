#include "services/supervisor/adapter.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "common/bus/sample_fields.hpp"
#include "common/robot/joints.hpp"

namespace scarab::supervisor {
namespace {

template <class Core, class Idl>
constexpr bool same(Core core, Idl idl) {
  return static_cast<int>(core) == static_cast<int>(idl);
}

static_assert(same(Mode::kStop, scarab_MODE_STOP) && same(Mode::kHardPush, scarab_MODE_HARD_PUSH) &&
              same(Mode::kStationary, scarab_MODE_STATIONARY));
static_assert(same(State::kIdle, scarab_BEHAVIOUR_IDLE) &&
              same(State::kMode1, scarab_BEHAVIOUR_MODE_1) &&
              same(State::kSafeStop, scarab_BEHAVIOUR_SAFE_STOP) &&
              same(State::kManual, scarab_BEHAVIOUR_MANUAL));
static_assert(same(Phase::kRunning, scarab_PHASE_RUNNING) &&
              same(Phase::kSafeStop, scarab_PHASE_SAFE_STOP) &&
              same(Phase::kHoming, scarab_PHASE_HOMING) &&
              same(Phase::kSucceeded, scarab_PHASE_SUCCEEDED) &&
              same(Phase::kFailed, scarab_PHASE_FAILED));

static_assert(same(Trigger::kNone, scarab_TRIGGER_NONE) &&
              same(Trigger::kFrontAngle, scarab_TRIGGER_FRONT_ANGLE) &&
              same(Trigger::kSupplyCurrent, scarab_TRIGGER_SUPPLY_CURRENT) &&
              same(Trigger::kFootForce, scarab_TRIGGER_FOOT_FORCE));

constexpr std::size_t kPitch = 1;  // index in inclination_rad

/// What is not measured is no number to the machine, which passes over such readings; a 0 would
/// look like an obstacle.
double reading(double value, scarab_Source source) {
  return source == scarab_SOURCE_ABSENT ? std::numeric_limits<double>::quiet_NaN() : value;
}

std::optional<OperatorWord::Command> to_command(scarab_OperatorCommand command) {
  switch (command) {
    case scarab_OPERATOR_AUTOMATIC:
      return OperatorWord::Command::kAutomatic;
    case scarab_OPERATOR_STRATEGY:
      return OperatorWord::Command::kStrategy;
    case scarab_OPERATOR_MODE:
      return OperatorWord::Command::kMode;
    case scarab_OPERATOR_INPUTS:
      return OperatorWord::Command::kInputs;
    case scarab_OPERATOR_START:
    case scarab_OPERATOR_PAUSE:
    case scarab_OPERATOR_STEP:
    case scarab_OPERATOR_STOP:
    case scarab_OPERATOR_EMERGENCY_STOP:
    case scarab_OPERATOR_RESET:
      return std::nullopt;
  }
  return std::nullopt;
}

scarab_OperatorCommand to_idl(OperatorWord::Command command) {
  switch (command) {
    case OperatorWord::Command::kAutomatic:
      return scarab_OPERATOR_AUTOMATIC;
    case OperatorWord::Command::kStrategy:
      return scarab_OPERATOR_STRATEGY;
    case OperatorWord::Command::kMode:
      return scarab_OPERATOR_MODE;
    case OperatorWord::Command::kInputs:
      return scarab_OPERATOR_INPUTS;
  }
  throw std::invalid_argument("no such command");
}

constexpr std::array<robot::Leg, 2> kFrontLegs = {robot::Leg::kL0, robot::Leg::kR0};

std::size_t f_slot(robot::Leg leg) { return robot::joint_slot(leg, robot::LegJoint::kFemurTibia); }

Measured to_measured(const scarab_RobotState& state) {
  const auto of_both = [](const auto& source_of) {
    return std::all_of(kFrontLegs.begin(), kFrontLegs.end(), [&source_of](robot::Leg leg) {
      return source_of(leg) == scarab_SOURCE_MEASURED;
    });
  };
  Measured measured;
  measured.front_angle = of_both([&](auto leg) { return state.position_source[f_slot(leg)]; });
  measured.supply_current = state.supply_current_source == scarab_SOURCE_MEASURED;
  measured.foot_force =
      of_both([&](auto leg) { return state.foot_force_source[robot::leg_slot(leg)]; });
  return measured;
}

}  // namespace

Perception to_perception(const scarab_RobotState& state) {
  Perception perception;
  perception.tick = state.header.tick;
  perception.phase = static_cast<Phase>(state.phase);
  perception.pitch_rad = reading(state.inclination_rad[kPitch], state.imu_source);
  for (std::size_t side = 0; side < kFrontLegs.size(); ++side) {
    const std::size_t joint = f_slot(kFrontLegs[side]), foot = robot::leg_slot(kFrontLegs[side]);
    perception.front_f_rad[side] = reading(state.position_rad[joint], state.position_source[joint]);
    perception.front_foot_n[side] =
        reading(state.foot_force_n[foot], state.foot_force_source[foot]);
  }
  perception.supply_current_a = reading(state.supply_current_a, state.supply_current_source);
  perception.measured = to_measured(state);
  return perception;
}

std::optional<OperatorWord> to_word(const scarab_Operator& said) {
  const auto command = to_command(said.command);
  if (!command) return std::nullopt;
  OperatorWord word;
  word.command = *command;
  word.mode = static_cast<Mode>(said.mode);
  std::copy(std::begin(said.inputs), std::end(said.inputs), word.inputs.begin());
  word.strategy = bus::text(said.strategy);
  word.reason = bus::text(said.reason);
  return word;
}

void fill(scarab_Operator& said, const OperatorWord& word) {
  said.command = to_idl(word.command);
  said.mode = static_cast<scarab_Mode>(word.mode);
  std::copy(word.inputs.begin(), word.inputs.end(), std::begin(said.inputs));
  bus::assign(said.strategy, word.strategy);
  bus::assign_truncated(said.reason, word.reason);
}

void fill(scarab_Behaviour& behaviour, const Decision& decision) {
  behaviour.mode = static_cast<scarab_Mode>(decision.mode);
  std::copy(decision.inputs.begin(), decision.inputs.end(), std::begin(behaviour.inputs));
  behaviour.hind_override = decision.hind_override;
  std::copy(decision.hind_pose_rad.begin(), decision.hind_pose_rad.end(),
            std::begin(behaviour.hind_pose_rad));
  behaviour.backbone_rad = decision.backbone_rad;
  behaviour.state = static_cast<scarab_BehaviourState>(decision.state);
  behaviour.entered_tick = decision.entered_tick;
  bus::assign_truncated(behaviour.reason, decision.reason.data());
  behaviour.bs_rad = decision.bs_rad;
  behaviour.bs_threshold_rad = decision.bs_threshold_rad;
  behaviour.as_rad = decision.as_rad;
  behaviour.as_threshold_rad = decision.as_threshold_rad;
  behaviour.trigger = static_cast<scarab_ObstacleTrigger>(decision.trigger);
  behaviour.trigger_value = decision.trigger_value;
  behaviour.trigger_threshold = decision.trigger_threshold;
}

}  // namespace scarab::supervisor
