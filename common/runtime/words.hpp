#pragma once

#include "common/bus/topics.hpp"

/// Values of the topics' enumerations as people read them: `mode 1`, `safe stop`.
namespace scarab::runtime {

const char* word(scarab_TrialPhase phase);
const char* word(scarab_BehaviourState state);
const char* word(scarab_ObstacleTrigger trigger);
const char* word(scarab_Lifecycle lifecycle);
const char* word(scarab_Health health);

}  // namespace scarab::runtime
