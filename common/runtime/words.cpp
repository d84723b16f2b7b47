#include "common/runtime/words.hpp"

namespace scarab::runtime {

const char* word(scarab_TrialPhase phase) {
  switch (phase) {
    case scarab_PHASE_RUNNING:
      return "running";
    case scarab_PHASE_SAFE_STOP:
      return "safe stop";
    case scarab_PHASE_HOMING:
      return "homing";
    case scarab_PHASE_SUCCEEDED:
      return "succeeded";
    case scarab_PHASE_FAILED:
      return "failed";
  }
  return "unknown";
}

const char* word(scarab_BehaviourState state) {
  switch (state) {
    case scarab_BEHAVIOUR_IDLE:
      return "idle";
    case scarab_BEHAVIOUR_APPROACH:
      return "approach";
    case scarab_BEHAVIOUR_CLIMB:
      return "climb";
    case scarab_BEHAVIOUR_MODE_1:
      return "mode 1";
    case scarab_BEHAVIOUR_MODE_2:
      return "mode 2";
    case scarab_BEHAVIOUR_DONE:
      return "done";
    case scarab_BEHAVIOUR_FAILED:
      return "failed";
    case scarab_BEHAVIOUR_SAFE_STOP:
      return "safe stop";
    case scarab_BEHAVIOUR_MANUAL:
      return "manual";
  }
  return "unknown";
}

const char* word(scarab_ObstacleTrigger trigger) {
  switch (trigger) {
    case scarab_TRIGGER_NONE:
      return "none";
    case scarab_TRIGGER_FRONT_ANGLE:
      return "front angle";
    case scarab_TRIGGER_SUPPLY_CURRENT:
      return "supply current";
    case scarab_TRIGGER_FOOT_FORCE:
      return "foot force";
  }
  return "unknown";
}

const char* word(scarab_Lifecycle lifecycle) {
  switch (lifecycle) {
    case scarab_LIFECYCLE_UNCONFIGURED:
      return "unconfigured";
    case scarab_LIFECYCLE_INACTIVE:
      return "inactive";
    case scarab_LIFECYCLE_ACTIVE:
      return "active";
    case scarab_LIFECYCLE_FINALISED:
      return "finalised";
  }
  return "unknown";
}

const char* word(scarab_Health health) {
  switch (health) {
    case scarab_HEALTH_OK:
      return "ok";
    case scarab_HEALTH_WAITING:
      return "waiting";
    case scarab_HEALTH_DEGRADED:
      return "degraded";
    case scarab_HEALTH_FAULT:
      return "fault";
  }
  return "unknown";
}

}  // namespace scarab::runtime
