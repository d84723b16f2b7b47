#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scarab::experiment {

/// The behaviour machine entered a state.
struct BehaviourChange {
  double time_s = 0;  ///< since the start of the trial
  std::string state;
  std::string reason;
};

/// How far a trial has come.
struct Progress {
  double time_s = 0;    ///< simulated
  double wall_s = 0;    ///< since the trial's first tick
  double travel_m = 0;  ///< of the object along the path
  std::string state;
};

/// What a trial is measured by, on the ground truth: from its first sample to its last.
struct Measures {
  double object_travel_m = 0;    ///< towards -x
  double object_sideways_m = 0;  ///< towards +y
  double trunk_travel_m = 0;     ///< horizontally, from the start pose
  double heading_rad = 0;        ///< of the trunk against its start, whole turns counted
  double heading_max_rad = 0;    ///< the largest amount of any sample
  std::optional<double> climb_s, mode1_s, mode2_s;  ///< when that was first entered
};

/// All that a trial's report says.
struct Outcome {
  std::uint32_t number = 0;
  std::string strategy;
  double height_m = 0;  ///< of the obstacle
  std::uint64_t seed = 0;
  bool success = false;
  std::string reason;
  bool judged = false;  ///< by the referee; false: there is no verdict, the reason says why
  Progress end;         ///< where it stood at the end
  Measures measures;
  std::vector<BehaviourChange> changes;
  std::string missed;  ///< which sample did not come, in words: the measures are not to be trusted
};

}  // namespace scarab::experiment
