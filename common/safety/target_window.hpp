#pragma once

#include "common/robot/robot_model.hpp"

/// Limits of one joint's target as free functions (rad). All return a value between the wanted one
/// and the one it is measured against, so that they may be applied one after another.
namespace scarab::safety {

/// `wanted_rad` moved into the position window `previous_rad` +- `velocity_rad_s` * `dt_s`.
[[nodiscard]] double within_window(double previous_rad, double wanted_rad, double velocity_rad_s,
                                   double dt_s);

/// `wanted_rad` moved to where a servo that stands at `measured_rad` asks for no more than its
/// torque limit: `measured_rad` +- limit / kp. A joint without stiffness has no such limit.
[[nodiscard]] double within_torque(const robot::Joint& joint, double measured_rad,
                                   double wanted_rad);

}  // namespace scarab::safety
