#pragma once

#include "common/bus/topics.hpp"
#include "services/premotor/core/premotor_controller.hpp"

/// IDL types <-> core types of the premotor controller. No I/O; headers are the caller's.
namespace scarab::premotor {

MotorIntent to_intent(const scarab_Behaviour& behaviour);

/// Fills all but the header. A stop carries the targets too, for logs; nobody applies them.
void fill(scarab_JointCommand& command, const robot::JointVector& targets_rad, bool stop);
void fill(scarab_NeuralActivity& activity, const NetworkState& state);

NetworkState to_network_state(const scarab_NeuralActivity& activity);

}  // namespace scarab::premotor
