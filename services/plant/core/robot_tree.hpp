#pragma once

#include <memory>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"

namespace scarab::plant {

/// The Simbody model of robot and object, the model of record: kinematics and inverse dynamics. The
/// stepper's own are written out for this tree and held against these (SimbodyCheck). Simbody's
/// headers stay behind this class (they take long to compile); simbody_model.hpp opens it for
/// tests.
class RobotTree {
 public:
  explicit RobotTree(const Morphology& morphology);
  ~RobotTree();
  RobotTree(RobotTree&& other) noexcept;
  RobotTree& operator=(RobotTree&& other) noexcept;
  RobotTree(const RobotTree&) = delete;
  RobotTree& operator=(const RobotTree&) = delete;

  /// Poses, velocities and joint axes at `state`. Also prepares inverse_dynamics().
  void update(const MotionState& state, Kinematics& kinematics);

  /// The generalised force (N, N m) that gives the generalised acceleration (rad/s2, m/s2) at the
  /// state of the last update(), without gravity.
  void inverse_dynamics(const SpeedVector& acceleration, SpeedVector& force);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scarab::plant
