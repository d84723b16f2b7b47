#include "common/safety/target_limiter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/robot/joint_limits.hpp"
#include "common/safety/target_window.hpp"

namespace scarab::safety {
namespace {

/// Takes over a limited value and counts whether it differs.
double counted(double before, double after, Clamp kind, GateCounters& counters) {
  if (after != before) ++counters.clamps[static_cast<std::size_t>(kind)];
  return after;
}

}  // namespace

TargetLimiter::TargetLimiter(robot::RobotModel robot, double tick_period_s,
                             double homing_velocity_rad_s)
    : robot_(std::move(robot)),
      tick_period_s_(tick_period_s),
      homing_velocity_rad_s_(homing_velocity_rad_s) {
  if (!(tick_period_s > 0) || !(homing_velocity_rad_s > 0)) {
    throw std::invalid_argument("TargetLimiter: tick period and homing velocity must be above 0");
  }
}

void TargetLimiter::start_from(const robot::JointVector& held_rad) {
  require_finite(held_rad, "held position");
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    target_rad_[slot] = robot_.joints[slot].present ? held_rad[slot] : 0.0;
  }
}

void TargetLimiter::require_finite(const robot::JointVector& angles_rad, const char* what) const {
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    if (!robot_.joints[slot].present || std::isfinite(angles_rad[slot])) continue;
    throw std::invalid_argument("TargetLimiter: the " + std::string(what) + " of " +
                                std::string(robot::kJointNames[slot]) + " is not finite");
  }
}

void TargetLimiter::advance(const robot::JointVector& wanted_rad,
                            const std::optional<robot::JointVector>& measured_rad,
                            GateCounters& counters) {
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    if (!robot_.joints[slot].present) continue;
    target_rad_[slot] = limited(slot, wanted_rad[slot], measured_rad, counters);
  }
}

/// The window comes last: whatever the other limits say, no joint is told to jump.
double TargetLimiter::limited(std::size_t slot, double wanted_rad,
                              const std::optional<robot::JointVector>& measured_rad,
                              GateCounters& counters) {
  const robot::Joint& joint = robot_.joints[slot];
  double target =
      counted(wanted_rad, robot::clipped_to_range(joint, wanted_rad), Clamp::kRange, counters);
  if (measured_rad) {
    target = counted(target, within_torque(joint, (*measured_rad)[slot], target), Clamp::kTorque,
                     counters);
  }
  const double reached =
      within_window(target_rad_[slot], target, joint.velocity_max_rad_s, tick_period_s_);
  return counted(target, reached, Clamp::kWindow, counters);
}

void TargetLimiter::advance_home(const robot::JointVector& home_rad) {
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    const robot::Joint& joint = robot_.joints[slot];
    if (!joint.present) continue;
    target_rad_[slot] =
        within_window(target_rad_[slot], home_rad[slot],
                      std::min(homing_velocity_rad_s_, joint.velocity_max_rad_s), tick_period_s_);
  }
}

robot::JointVector TargetLimiter::reachable(const robot::JointVector& home_rad) const {
  require_finite(home_rad, "start pose");
  return robot::clipped_to_ranges(robot_, home_rad);
}

}  // namespace scarab::safety
