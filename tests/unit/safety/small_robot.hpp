#pragma once

#include "common/robot/robot_model.hpp"
#include "common/safety/command_gate.hpp"

namespace scarab::safety {

/// All joints alike: range [-1, 0.5] rad, 2 rad/s, kp 10, 4 N m; no backbone.
inline robot::RobotModel small_robot() {
  robot::RobotModel model;
  for (robot::Joint& joint : model.joints) {
    joint.min_rad = -1.0;
    joint.max_rad = 0.5;
    joint.velocity_max_rad_s = 2.0;
    joint.torque_max_nm = 4.0;
    joint.kp_nm_rad = 10.0;
  }
  model.joints[robot::kBackboneSlot].present = false;
  return model;
}

inline constexpr double kTickPeriod = 0.1;  // s
inline constexpr double kWindow = 0.2;      // rad: 2 rad/s for a tick

inline robot::JointVector all(double angle_rad) {
  robot::JointVector result{};
  result.fill(angle_rad);
  return result;
}

inline Offer position(std::uint32_t tick, double angle_rad, std::uint32_t trial = 1) {
  return {trial, tick, false, all(angle_rad)};
}

inline Offer stop(std::uint32_t tick, std::uint32_t trial = 1) { return {trial, tick, true, {}}; }

/// In trial 1, standing at 0, asked for tick 0.
inline CommandGate ready_gate(std::uint32_t stale_ticks_limit = 0) {
  CommandGate gate(small_robot(), GateOptions{kTickPeriod, 0.5, stale_ticks_limit});
  gate.begin_trial(1, all(0), all(0));
  gate.expect(0);
  return gate;
}

}  // namespace scarab::safety
