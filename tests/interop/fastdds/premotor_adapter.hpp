#pragma once

#include <behaviour.h>
#include <joint_command.h>
#include <neural_activity.h>

#include "services/premotor/core/premotor_controller.hpp"

/// Fast DDS's classes of the IDL types <-> the premotor controller's own types.
namespace scarab::fastdds {

premotor::MotorIntent to_intent(const Behaviour& behaviour);
/// Both fill all but the header.
void fill(NeuralActivity& activity, const premotor::NetworkState& state);
void fill(JointCommand& command, const robot::JointVector& targets_rad, bool stop);

}  // namespace scarab::fastdds
