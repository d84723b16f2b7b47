#pragma once

#include <cstdint>

namespace scarab::plant {

/// Values equal those of the IDL enumeration GoalKind.
enum class Goal {
  kNone,    ///< run to the time limit, which is then the success
  kTravel,  ///< the object has travelled goal_distance_m (paper, experiment 1)
  kAcross,  ///< the object is across the obstacle (paper, experiment 2)
  kWalk     ///< the robot is goal_distance_m away from its start; no object is judged
};

/// What the plant takes from scarab/trial: scene, goal, seed and size of the perturbation.
struct TrialSpec {
  Goal goal = Goal::kNone;
  double goal_distance_m = 0;    ///< for Goal::kTravel and Goal::kWalk
  double time_limit_s = 60;      ///< simulated time
  double obstacle_height_m = 0;  ///< 0: no obstacle
  std::uint64_t seed = 0;
  double perturb_position_m = 0;  ///< start position: uniform in +- this, x and y
  double perturb_yaw_rad = 0;     ///< start heading: uniform in +- this
  double perturb_friction = 0;    ///< each coefficient: a factor of its own, uniform in 1 +- this
  double friction_scale = 0;      ///< of every friction coefficient; 0: as configured, like 1
  double object_mass_kg = 0;      ///< 0: as configured
  double object_diameter_m = 0;   ///< 0: as configured
};

}  // namespace scarab::plant
