#pragma once

#include <cstdint>
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

/// All that a trial's report says.
struct Outcome {
  std::uint32_t number = 0;
  std::string strategy;
  double height_m = 0;  ///< of the obstacle
  std::uint64_t seed = 0;
  bool success = false;
  std::string reason;
  Progress end;  ///< where it stood at the end
  std::vector<BehaviourChange> changes;
};

}  // namespace scarab::experiment
