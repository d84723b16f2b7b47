#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/robot/joints.hpp"

namespace scarab::test {

/// What a log says of how its one trial went, tick by tick.
struct RecordedTrial {
  std::vector<robot::JointVector> position_rad;  ///< of robot_state, by tick
  std::vector<std::string> behaviours;           ///< states in the order in which they were entered
  std::size_t walks_from = 0;                    ///< tick at which the approach began
};

/// Throws std::runtime_error if a tick is missing, or if nobody has approached.
RecordedTrial read_recorded_trial(const std::filesystem::path& log);

/// Root mean square of the difference of all joints' angles over `ticks` ticks from where each
/// trial began to walk, rad.
double rms_difference_rad(const RecordedTrial& a, const RecordedTrial& b, std::size_t ticks);

}  // namespace scarab::test
