#pragma once

#include <string>

namespace scarab::search {

/// What the objective takes from one trial.
struct Measure {
  bool success = false;
  double time_s = 0;  ///< when it ended
  /// Way made towards the goal, share in [0, 1]: of the object's way to the far side of the
  /// obstacle (goal across), of the distance (travel, walk).
  double progress = 0;
  /// Rise of the object's axis as a share of the obstacle's height, most of the trial, in [0, 1];
  /// 0 without an obstacle.
  double lift = 0;
  double heading_max_rad = 0;     ///< largest deviation from the heading at the start
  double leg_leg_share = 0;       ///< share of samples in which two legs touch
  double carry_share = 0;         ///< mean share of the object's weight on trunk, coxae and femora
  double approach_pitch_rad = 0;  ///< largest |BS| before the robot first touches the object
  std::string reason;             ///< the referee's, or why it was abandoned
};

}  // namespace scarab::search
