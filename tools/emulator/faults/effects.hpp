#pragma once

#include <array>
#include <bitset>
#include <optional>
#include <vector>

#include "common/robot/joints.hpp"
#include "tools/emulator/faults/fault.hpp"

namespace scarab::emulator {

/// What the active faults do, all together.
struct Effects {
  double lose = 0;  ///< probability per byte
  double flip = 0;  ///< probability per byte
  double late_s = 0;
  bool unplugged = false;
  bool board_silent = false;
  bool imu_silent = false;
  std::bitset<robot::kJointCount> silent;
  std::bitset<robot::kJointCount> stuck;
  std::array<std::optional<double>, robot::kJointCount> temperature_c;
  robot::JointVector extra_current_a{};
  double tilt_rad = 0;
  std::array<std::optional<double>, robot::kJointCount> pose_rad;
};

/// Of two faults of a kind about the same thing the later one counts.
[[nodiscard]] Effects effects_of(const std::vector<Fault>& faults);

}  // namespace scarab::emulator
