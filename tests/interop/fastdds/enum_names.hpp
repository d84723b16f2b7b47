#pragma once

#include <behaviour.h>
#include <header.h>
#include <joint_command.h>
#include <operator.h>
#include <robot_state.h>
#include <service_status.h>
#include <trial.h>
#include <world_state.h>

#include <array>

/// The literals of the IDL's enums: fastddsgen makes numbers of them.
namespace scarab::fastdds {

constexpr auto names_of(Source /*type*/) {
  return std::array{"SOURCE_ABSENT", "SOURCE_MEASURED", "SOURCE_COMMANDED"};
}
constexpr auto names_of(Mode /*type*/) {
  return std::array{"MODE_STOP",   "MODE_FORWARD",    "MODE_BACKWARD", "MODE_SOFT_PUSH",
                    "MODE_BOXING", "MODE_STATIONARY", "MODE_HARD_PUSH"};
}
constexpr auto names_of(BehaviourState /*type*/) {
  return std::array{"BEHAVIOUR_IDLE",   "BEHAVIOUR_APPROACH",  "BEHAVIOUR_CLIMB",
                    "BEHAVIOUR_MODE_1", "BEHAVIOUR_MODE_2",    "BEHAVIOUR_DONE",
                    "BEHAVIOUR_FAILED", "BEHAVIOUR_SAFE_STOP", "BEHAVIOUR_MANUAL"};
}
constexpr auto names_of(ObstacleTrigger /*type*/) {
  return std::array{"TRIGGER_NONE", "TRIGGER_FRONT_ANGLE", "TRIGGER_SUPPLY_CURRENT",
                    "TRIGGER_FOOT_FORCE"};
}
constexpr auto names_of(CommandKind /*type*/) {
  return std::array{"COMMAND_STOP", "COMMAND_POSITION"};
}
constexpr auto names_of(OperatorCommand /*type*/) {
  return std::array{"OPERATOR_START",     "OPERATOR_PAUSE",          "OPERATOR_STEP",
                    "OPERATOR_STOP",      "OPERATOR_EMERGENCY_STOP", "OPERATOR_RESET",
                    "OPERATOR_AUTOMATIC", "OPERATOR_STRATEGY",       "OPERATOR_MODE",
                    "OPERATOR_INPUTS"};
}
constexpr auto names_of(TrialPhase /*type*/) {
  return std::array{"PHASE_RUNNING", "PHASE_SAFE_STOP", "PHASE_HOMING", "PHASE_SUCCEEDED",
                    "PHASE_FAILED"};
}
constexpr auto names_of(Lifecycle /*type*/) {
  return std::array{"LIFECYCLE_UNCONFIGURED", "LIFECYCLE_INACTIVE", "LIFECYCLE_ACTIVE",
                    "LIFECYCLE_FINALISED"};
}
constexpr auto names_of(Health /*type*/) {
  return std::array{"HEALTH_OK", "HEALTH_WAITING", "HEALTH_DEGRADED", "HEALTH_FAULT"};
}
constexpr auto names_of(GoalKind /*type*/) {
  return std::array{"GOAL_NONE", "GOAL_TRAVEL", "GOAL_ACROSS", "GOAL_WALK"};
}
constexpr auto names_of(Verdict /*type*/) {
  return std::array{"VERDICT_OPEN", "VERDICT_SUCCESS", "VERDICT_FAILURE"};
}
constexpr auto names_of(Solid /*type*/) {
  return std::array{"SOLID_GROUND", "SOLID_OBJECT", "SOLID_OBSTACLE", "SOLID_TRUNK",
                    "SOLID_COXA",   "SOLID_FEMUR",  "SOLID_TIBIA",    "SOLID_FOOT"};
}

}  // namespace scarab::fastdds
