#pragma once

#include "common/robot/joints.hpp"
#include "services/plant/core/bodies.hpp"
#include "services/plant/core/contact_geometry.hpp"
#include "services/plant/core/morphology.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/plant/core/trial_spec.hpp"

namespace scarab::plant {

/// Start pose of the robot against the unperturbed one.
struct Perturbation {
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;
};

/// Uniform within the trial's bounds; a pure function of its seed.
[[nodiscard]] Perturbation perturbation(const TrialSpec& trial);

/// The configuration as the trial changes it: its object, out of the way of a walk; its friction
/// coefficients, scaled and perturbed by its seed. Throws std::invalid_argument for a scale, mass
/// or diameter that is negative or not finite, and for a perturbation outside of [0, 1).
[[nodiscard]] PlantConfig scene_config(PlantConfig config, const TrialSpec& trial);

/// The wall of the trial; height 0 where there is none.
[[nodiscard]] Wall make_wall(const PlantConfig& config, const TrialSpec& trial);

/// The stance of the start as joint targets, rad.
[[nodiscard]] robot::JointVector start_targets(const StartConfig& start);

/// Robot at rest with its joints at `joint_rad` (rad; an absent joint's is ignored), its lowest
/// foot touching the ground, trunk level; object at rest behind it (towards -x), touching the
/// ground.
[[nodiscard]] MotionState start_state(const Morphology& morphology, const PlantConfig& config,
                                      const Perturbation& perturbation,
                                      const robot::JointVector& joint_rad);

/// The same in the configured stance.
[[nodiscard]] MotionState start_state(const Morphology& morphology, const PlantConfig& config,
                                      const Perturbation& perturbation);

}  // namespace scarab::plant
