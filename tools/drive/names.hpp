#pragma once

#include "common/bus/topics.hpp"

/// Values of the IDL's enumerations in words.
namespace scarab::drive {

const char* name(scarab_TrialPhase phase);
const char* name(scarab_BehaviourState state);
const char* name(scarab_Lifecycle lifecycle);

}  // namespace scarab::drive
