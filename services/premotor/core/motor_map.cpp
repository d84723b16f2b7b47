#include "services/premotor/core/motor_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace scarab::premotor {
namespace {

using robot::Leg;
using robot::LegJoint;

constexpr std::array<const char*, 3> kRowNames = {"front", "middle", "hind"};

void require_finite(const char* row, const MotorRowConfig& config) {
  const std::array<double, 8> values = {
      config.t_offset_rad, config.t_gain_rad,    config.c_offset_rad, config.c_gain_rad,
      config.c_floor,      config.c_i4_gain_rad, config.f_offset_rad, config.f_i3_gain_rad};
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) {
    throw std::invalid_argument(std::string("motor map, ") + row + " legs: a value is not finite");
  }
}

/// T, C, F of a leg before clipping.
std::array<double, 3> leg_angles(const MotorRowConfig& row, const NetworkState& state, Leg leg) {
  const double t = state.motor[joint_slot(leg, LegJoint::kThoracoCoxal)];
  const double c = state.motor[joint_slot(leg, LegJoint::kCoxaTrochanteral)];
  const double i3 = state.input[2];
  const double i4 = state.input[3];
  return {row.t_offset_rad + row.t_gain_rad * t,
          row.c_offset_rad + row.c_gain_rad * std::max(row.c_floor, c) + row.c_i4_gain_rad * i4,
          row.f_offset_rad + row.f_i3_gain_rad * i3};
}

}  // namespace

MotorMap::MotorMap(const MotorConfig& config, const robot::RobotModel& robot)
    : rows_{config.front, config.middle, config.hind}, joints_(robot.joints) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    require_finite(kRowNames[i], rows_[i]);
  }
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    if (joints_[slot].present && !(joints_[slot].min_rad <= joints_[slot].max_rad)) {
      throw std::invalid_argument("joint " + std::string(robot::kJointNames[slot]) +
                                  ": its range is empty");
    }
  }
}

robot::JointVector MotorMap::targets(const NetworkState& state, const HindPose& hind_pose,
                                     double backbone_rad) const {
  robot::JointVector target{};
  for (const Leg leg : robot::kLegs) {
    const std::size_t row = robot::row(leg);
    const auto angles = row == 2 && hind_pose ? *hind_pose : leg_angles(rows_[row], state, leg);
    for (std::size_t j = 0; j < angles.size(); ++j) {
      target[joint_slot(leg, static_cast<LegJoint>(j))] = angles[j];
    }
  }
  target[robot::kBackboneSlot] = backbone_rad;
  for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
    const robot::Joint& joint = joints_[slot];
    target[slot] = joint.present ? std::clamp(target[slot], joint.min_rad, joint.max_rad) : 0;
  }
  return target;
}

}  // namespace scarab::premotor
