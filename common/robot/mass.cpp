#include "common/robot/mass.hpp"

namespace scarab::robot {

double total_mass_kg(const RobotModel& model) {
  double mass_kg = model.trunk.mass_kg;
  for (const LegRow& row : model.rows) {
    const double leg_kg =
        row.shoulder.mass_kg + row.coxa.mass_kg + row.femur.mass_kg + row.tibia.mass_kg;
    mass_kg += 2.0 * leg_kg;  // left and right
  }
  return mass_kg;
}

}  // namespace scarab::robot
