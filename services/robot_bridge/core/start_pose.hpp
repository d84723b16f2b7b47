#pragma once

#include <array>

#include "common/robot/joints.hpp"

namespace scarab::bridge {

/// How the robot stands before the first command: T, C, F of each row of legs, left as right.
struct StartPose {
  std::array<double, 3> front_rad{};
  std::array<double, 3> middle_rad{};
  std::array<double, 3> hind_rad{};
  double backbone_rad = 0;
};

/// The same by joint slots, rad.
[[nodiscard]] robot::JointVector joint_targets(const StartPose& pose);

}  // namespace scarab::bridge
