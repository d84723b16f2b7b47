#include "services/plant/core/servo.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::plant {

double slew(const robot::Joint& joint, double reference_rad, double target_rad, double dt_s) {
  const double step = joint.velocity_max_rad_s * dt_s;
  return reference_rad + std::clamp(target_rad - reference_rad, -step, step);
}

JointTorque servo_torque(const robot::Joint& joint, double reference_rad, double angle_rad,
                         double speed_rad_s, double dt_s) {
  const double spring = joint.kp_nm_rad * (reference_rad - angle_rad);
  const double damping = joint.kd_nm_s_rad + dt_s * joint.kp_nm_rad;
  const double expected = spring - damping * speed_rad_s;
  if (std::abs(expected) > joint.torque_max_nm) {
    return {std::copysign(joint.torque_max_nm, expected), 0};
  }
  return {spring, damping};
}

JointTorque gear_drag(const robot::Joint& joint) {
  constexpr double kShare = 0.1;
  return {0, kShare * joint.kd_nm_s_rad};
}

JointTorque stop_torque(const JointStopConfig& stop, const robot::Joint& joint, double angle_rad,
                        double speed_rad_s, double dt_s) {
  const double beyond =
      angle_rad > joint.max_rad ? angle_rad - joint.max_rad : angle_rad - joint.min_rad;
  if (angle_rad <= joint.max_rad && angle_rad >= joint.min_rad) return {};
  const double spring = -stop.stiffness_nm_rad * beyond;
  const double damping = stop.damping_nm_s_rad + dt_s * stop.stiffness_nm_rad;
  // A stop does not hold a joint back that leaves it.
  if ((spring - damping * speed_rad_s) * spring <= 0) return {};
  return {spring, damping};
}

}  // namespace scarab::plant
