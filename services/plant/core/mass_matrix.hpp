#pragma once

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// Mass matrix and gravity in generalised coordinates, by composite rigid bodies.
///
/// With S_j the motion subspace of joint j (spatial velocity about the trunk's origin O, world
/// axes) and I_j the composite spatial inertia of everything outboard of j, M_ij = S_i^T I_j S_j
/// for i inboard of j (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.2). Gravity is
/// uniform, so each joint carries the weight of its composite body at that body's centre of mass.
/// Takes about a twentieth of the time of Simbody's calcM and agrees with it (test).
class MassMatrix {
 public:
  explicit MassMatrix(const Morphology& morphology);

  /// Fills the lower triangle of `mass` (kg, kg m, kg m2; the rest stays as it was) and `gravity`,
  /// the generalised force (N, N m) of a gravity of `gravity_m_s2` along -z.
  void compute(const Kinematics& kinematics, double gravity_m_s2, SpeedMatrix& mass,
               SpeedVector& gravity) const;

 private:
  std::array<BodyMass, kBodyCount> mass_;
  std::array<bool, robot::kLegCount> leg_on_front_;
};

}  // namespace scarab::plant
