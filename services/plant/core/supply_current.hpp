#pragma once

#include "common/robot/joints.hpp"
#include "services/plant/core/plant_config.hpp"

namespace scarab::plant {

/// What an ammeter at the robot's supply shows, A, for the servos' torques on their joints:
///
///     I = idle + sum_j |torque_j| / torque constant
///
/// A servo that holds still or is turned by its load draws what its torque needs, as a servo's own
/// controller does that lets nothing back into the supply. Left out: the supply's voltage, the
/// friction of gears, the inductance of motors.
[[nodiscard]] double supply_current_a(const SupplyConfig& supply,
                                      const robot::JointVector& servo_torque_nm);

}  // namespace scarab::plant
