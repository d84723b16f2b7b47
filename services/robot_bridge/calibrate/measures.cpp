#include "services/robot_bridge/calibrate/measures.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::bridge::calibrate {

double offset_of(double servo_rad, int direction, double joint_rad) {
  return servo_rad - direction * joint_rad;
}

std::optional<int> direction_of(double servo_before_rad, double servo_after_rad) {
  const double turned_rad = servo_after_rad - servo_before_rad;
  if (std::abs(turned_rad) < kLeastMove_rad) return std::nullopt;
  return turned_rad > 0 ? 1 : -1;
}

void Travel::see(double servo_rad) {
  min_rad_ = std::min(min_rad_, servo_rad);
  max_rad_ = std::max(max_rad_, servo_rad);
}

JointCalibration measured(double servo_rad, double joint_rad, int direction, const Travel& travel) {
  const double offset_rad = offset_of(servo_rad, direction, joint_rad);
  return {offset_rad, direction, std::min(travel.min_rad(), offset_rad),
          std::max(travel.max_rad(), offset_rad)};
}

std::optional<JointCalibration> driven(const JointCalibration& nominal, const Standing& first,
                                       const Standing& second) {
  const double joint_move_rad = second.joint_rad - first.joint_rad;
  const double servo_move_rad = second.servo_rad - first.servo_rad;
  if (std::min(std::abs(joint_move_rad), std::abs(servo_move_rad)) < kLeastMove_rad) {
    return std::nullopt;
  }
  const double stretch = std::abs(joint_move_rad / servo_move_rad);
  const int direction = joint_move_rad * servo_move_rad > 0 ? 1 : -1;
  const double offset_rad = offset_of(stretch * first.servo_rad, direction, first.joint_rad);
  return JointCalibration{offset_rad, direction, std::min(stretch * nominal.min_rad, offset_rad),
                          std::max(stretch * nominal.max_rad, offset_rad)};
}

double second_look_rad(const robot::Joint& joint, double first_rad) {
  constexpr double kStep_rad = 0.5;
  const double above_rad = joint.max_rad - first_rad;
  const double below_rad = first_rad - joint.min_rad;
  return above_rad >= below_rad ? first_rad + std::min(kStep_rad, above_rad)
                                : first_rad - std::min(kStep_rad, below_rad);
}

bool covers(const JointCalibration& c, const robot::Joint& joint) {
  constexpr double kTolerance_rad = 0.01;
  const JointRange range = reach(c);
  return range.min_rad <= joint.min_rad + kTolerance_rad &&
         range.max_rad >= joint.max_rad - kTolerance_rad;
}

}  // namespace scarab::bridge::calibrate
