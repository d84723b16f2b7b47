#include "services/plant/core/supply_current.hpp"

#include <cmath>

namespace scarab::plant {

double supply_current_a(const SupplyConfig& supply, const robot::JointVector& servo_torque_nm) {
  double total_nm = 0;
  for (const double torque : servo_torque_nm) total_nm += std::abs(torque);
  return supply.idle_a + total_nm / supply.torque_constant_nm_a;
}

}  // namespace scarab::plant
