#pragma once

#include <array>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"
// After Eigen, and never with a using-directive: SimTK's operator templates match Eigen's types.
#include <Simbody.h>

namespace scarab::plant {

/// The multibody system itself. Including this header costs seconds of compile time: only
/// robot_tree.cpp and tests do.
class SimbodyModel {
 public:
  explicit SimbodyModel(const Morphology& morphology);

  /// Called once after any force was added to `forces`: fixes the topology and the speed order.
  void finish();

  void write(const MotionState& motion, SimTK::State& state) const;
  [[nodiscard]] MotionState read(const SimTK::State& state) const;

  /// Needs `state` realised to Stage::Velocity.
  void read_kinematics(const SimTK::State& state, Kinematics& kinematics) const;

  /// Simbody's index of each generalised speed of bodies.hpp.
  [[nodiscard]] const std::array<int, kSpeedCount>& speed_index() const { return speed_index_; }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  std::array<SimTK::MobilizedBodyIndex, kBodyCount> body;

 private:
  Morphology morphology_;
  std::array<int, kSpeedCount> speed_index_{};
  std::array<int, robot::kJointCount> joint_q_{};
  int trunk_q_ = 0;
  int object_q_ = 0;
};

}  // namespace scarab::plant
