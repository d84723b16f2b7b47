#pragma once

#include "common/robot/robot_model.hpp"
#include "common/runtime/options.hpp"
#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

/// Serves as the premotor controller until SIGINT or SIGTERM: behaviour k in, joint_command k and
/// neural_activity k out. Throws bus::Error when the bus cannot be joined.
void serve(const runtime::ServiceOptions& options, const PremotorConfig& config,
           const robot::RobotModel& robot);

}  // namespace scarab::premotor
