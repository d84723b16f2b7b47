#pragma once

#include "common/robot/robot_model.hpp"
#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

/// config/premotor/beetle.yaml and config/robot/beetle.yaml as they stand: the tests hold the
/// shipped parameters to the properties, not a copy of them.
PremotorConfig f2_config();
robot::RobotModel beetle();

}  // namespace scarab::premotor
