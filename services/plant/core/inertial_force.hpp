#pragma once

#include <array>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// Coriolis and centrifugal forces in generalised coordinates, by the recursive Newton-Euler
/// algorithm (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 5.3).
///
/// Outwards, the acceleration of every body for zero generalised acceleration; inwards, the force
/// and the moment about the trunk's origin that it takes, of which each joint carries the component
/// along its axis. Agrees with Simbody's inverse dynamics (test, SimbodyCheck).
class InertialForce {
 public:
  explicit InertialForce(const Morphology& morphology);

  /// The generalised force (N, N m) that must act for zero generalised acceleration, without
  /// gravity, at the poses and velocities of `kinematics`.
  void compute(const Kinematics& kinematics, SpeedVector& force) const;

 private:
  std::array<BodyMass, kBodyCount> mass_;
  std::array<bool, robot::kLegCount> leg_on_front_;
};

}  // namespace scarab::plant
