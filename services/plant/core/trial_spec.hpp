#pragma once

#include <cstdint>

namespace scarab::plant {

/// Values equal those of the IDL enumeration GoalKind.
enum class Goal {
  kNone,    ///< run to the time limit, which is then the success
  kTravel,  ///< the object has travelled goal_distance_m (paper, experiment 1)
  kAcross   ///< the object is across the obstacle (paper, experiment 2)
};

/// What the plant takes from scarab/trial: scene, goal, seed and size of the perturbation.
struct TrialSpec {
  Goal goal = Goal::kNone;
  double goal_distance_m = 0;    ///< for Goal::kTravel
  double time_limit_s = 60;      ///< simulated time
  double obstacle_height_m = 0;  ///< 0: no obstacle
  std::uint64_t seed = 0;
  double perturb_position_m = 0;  ///< start position: uniform in +- this, x and y
  double perturb_yaw_rad = 0;     ///< start heading: uniform in +- this
};

}  // namespace scarab::plant
