#pragma once

#include <array>

#include "common/robot/joints.hpp"

namespace scarab::plant {

/// What the robot's own sensors read (adapter: scarab/robot_state). Absent joints read 0.
struct Observation {
  robot::JointVector position_rad{};
  robot::JointVector velocity_rad_s{};
  robot::JointVector torque_nm{};                  ///< of the servo, on the joint
  robot::LegVector foot_force_n{};                 ///< normal force on the foot, >= 0
  double roll_rad = 0;                             ///< of the rear trunk, + = left side up
  double pitch_rad = 0;                            ///< of the rear trunk, + = rear up
  std::array<double, 3> angular_velocity_rad_s{};  ///< of the rear trunk, in its own frame
  double supply_current_a = 0;                     ///< of all servos and electronics
  std::array<double, 3> acceleration_m_s2{};  ///< specific force, in its own frame; at rest (0,0,g)
};

}  // namespace scarab::plant
