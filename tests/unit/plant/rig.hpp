#pragma once

#include "common/robot/robot_model.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/plant/core/scene.hpp"
#include "services/plant/core/stepper.hpp"

namespace scarab::plant::testing {

/// config/robot/beetle.yaml.
[[nodiscard]] robot::RobotModel beetle();

/// config/plant/beetle.yaml.
[[nodiscard]] PlantConfig default_config();

/// AMOS II with plain mounts and the servos of the walking figures: legs straight out sideways.
[[nodiscard]] robot::RobotModel plain_walker();

/// Morphology, stepper and state of one scene, for tests that look inside a simulation.
struct Rig {
  Rig(const robot::RobotModel& robot, const PlantConfig& config, const Wall& wall = {});

  void step(double dt_s) { stepper.step(targets, dt_s, reference, state); }
  void run(double duration_s, double dt_s);
  /// Takes the object far out of the robot's way (it stays on the ground).
  void remove_object();
  /// Lifts everything, so that nothing touches.
  void lift(double height_m);

  Morphology morphology;
  PlantConfig config;
  Stepper stepper;
  MotionState state;
  robot::JointVector targets;
  robot::JointVector reference;
};

/// Total mass of the robot, kg.
[[nodiscard]] double robot_mass(const Morphology& morphology);

/// Kinematics of a state, by a model of its own.
[[nodiscard]] Kinematics kinematics_of(const Morphology& morphology, const MotionState& state);

/// A state away from every symmetry, at speed.
[[nodiscard]] MotionState odd_state(const Morphology& morphology, int variant);

}  // namespace scarab::plant::testing
