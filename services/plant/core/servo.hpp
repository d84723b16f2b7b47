#pragma once

#include "common/robot/robot_model.hpp"
#include "services/plant/core/plant_config.hpp"

namespace scarab::plant {

/// Torque on a joint, linear in its speed u at the end of the step: torque - damping u.
struct JointTorque {
  double torque_nm = 0;
  double damping_nm_s_rad = 0;
};

/// The servo's reference after dt_s: it slews towards `target_rad` at no more than the joint's
/// speed.
[[nodiscard]] double slew(const robot::Joint& joint, double reference_rad, double target_rad,
                          double dt_s);

/// Position servo, kp (reference - q) - kd u, within +- its torque limit. The spring acts at the
/// end of the step; a saturated servo gives its limit and no damping.
[[nodiscard]] JointTorque servo_torque(const robot::Joint& joint, double reference_rad,
                                       double angle_rad, double speed_rad_s, double dt_s);

/// A servo without power: its gear's drag alone, a tenth of the servo's damping (a reconstruction:
/// nobody publishes it; a limp leg swings, and comes to rest within a second).
[[nodiscard]] JointTorque gear_drag(const robot::Joint& joint);

/// Stop at the ends of the joint's range: a stiff spring and damper that only push back.
[[nodiscard]] JointTorque stop_torque(const JointStopConfig& stop, const robot::Joint& joint,
                                      double angle_rad, double speed_rad_s, double dt_s);

}  // namespace scarab::plant
