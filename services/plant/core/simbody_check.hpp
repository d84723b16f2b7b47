#pragma once

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/robot_tree.hpp"

namespace scarab::plant {

/// Holds the stepper's own account of a motion against Simbody's, the model of record, while the
/// plant runs: poses and velocities of all bodies, and M a + C(q, u) against Simbody's inverse
/// dynamics for the same acceleration.
class SimbodyCheck {
 public:
  explicit SimbodyCheck(const Morphology& morphology) : tree_(morphology) {}

  /// `mass`: its lower triangle; `inertial`: C(q, u); `acceleration`: any, N, m and rad units.
  /// Throws std::logic_error, naming what differs, if anything does by more than a share of 1e-9.
  void compare(const MotionState& state, const Kinematics& kinematics, const SpeedMatrix& mass,
               const SpeedVector& inertial, const SpeedVector& acceleration);

 private:
  RobotTree tree_;
  Kinematics expected_;
  SpeedVector expected_force_;
};

}  // namespace scarab::plant
