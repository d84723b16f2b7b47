#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "common/robot/joints.hpp"

namespace scarab::test {

/// How a robot walked, from the log of one trial.
struct Walk {
  double time_s = 0;
  double ahead_m = 0;                           ///< way along the heading at the start
  double sideways_m = 0;                        ///< to the left of it
  double turned_rad = 0;                        ///< to the left
  double tilt_most_rad = 0;                     ///< of the trunk's vertical
  double height_least_m = 0;                    ///< of the trunk's centre
  robot::LegVector air_share{};                 ///< of the time that each foot was off the ground
  std::vector<robot::JointVector> targets_rad;  ///< of every command, in order
};

/// Throws std::runtime_error if the log has no trial in it.
Walk read_walk(const std::filesystem::path& log);

/// Samples of robot_state and robot_sensors in which the joint is not marked absent, or in which
/// one of its numbers is not 0; and commands in which its target is not 0.
std::size_t traces_of_joint(const std::filesystem::path& log, std::size_t slot);

}  // namespace scarab::test
