#pragma once

#include "common/robot/robot_model.hpp"

/// Limits of one joint's target as free functions.
namespace scarab::safety {

/// `wanted_rad` moved into the position window: `previous_rad` +- velocity limit * dt.
[[nodiscard]] double within_window(const robot::Joint& joint, double previous_rad,
                                   double wanted_rad, double dt_s);

/// `wanted_rad` moved to where a servo at `measured_rad` and at rest asks for no more than its
/// torque limit: measured +- torque limit / kp. A joint without stiffness has no such limit.
[[nodiscard]] double within_torque(const robot::Joint& joint, double measured_rad,
                                   double wanted_rad);

}  // namespace scarab::safety
