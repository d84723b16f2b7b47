#pragma once

#include <memory>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// The Simbody model of robot and object: kinematics and velocity-dependent inertial forces.
/// Contact, servos and integration are the stepper's. Simbody's headers stay behind this class
/// (they take long to compile); simbody_model.hpp opens it for cross-checks.
class RobotTree {
 public:
  explicit RobotTree(const Morphology& morphology);
  ~RobotTree();
  RobotTree(RobotTree&& other) noexcept;
  RobotTree& operator=(RobotTree&& other) noexcept;
  RobotTree(const RobotTree&) = delete;
  RobotTree& operator=(const RobotTree&) = delete;

  /// Poses, velocities and joint axes at `state`. Also prepares inertial_force().
  void update(const MotionState& state, Kinematics& kinematics);

  /// Coriolis and centrifugal force (N, N m) at the state of the last update(): what must act for
  /// zero generalised acceleration, without gravity.
  void inertial_force(SpeedVector& force);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scarab::plant
