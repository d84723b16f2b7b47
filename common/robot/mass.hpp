#pragma once

#include "common/robot/robot_model.hpp"

namespace scarab::robot {

/// Mass of the trunk and of all segments of all six legs (kg).
[[nodiscard]] double total_mass_kg(const RobotModel& model);

}  // namespace scarab::robot
