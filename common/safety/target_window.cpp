#include "common/safety/target_window.hpp"

#include <algorithm>

namespace scarab::safety {

double within_window(double previous_rad, double wanted_rad, double velocity_rad_s, double dt_s) {
  const double reach_rad = velocity_rad_s * dt_s;
  return std::clamp(wanted_rad, previous_rad - reach_rad, previous_rad + reach_rad);
}

double within_torque(const robot::Joint& joint, double measured_rad, double wanted_rad) {
  if (joint.kp_nm_rad <= 0) return wanted_rad;
  const double reach_rad = joint.torque_max_nm / joint.kp_nm_rad;
  return std::clamp(wanted_rad, measured_rad - reach_rad, measured_rad + reach_rad);
}

}  // namespace scarab::safety
