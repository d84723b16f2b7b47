#include "services/robot_bridge/calibrate/own_scales.hpp"

namespace scarab::bridge::calibrate {
namespace {

constexpr double kHalfTurn_rad = 3.14159265358979323846;

template <class ScaleOf>
Calibration each_joint(const robot::RobotModel& robot, ScaleOf scale_of) {
  Calibration scales;
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    if (robot.joints[joint].present) scales.joints[joint] = scale_of(joint);
  }
  return scales;
}

}  // namespace

Calibration own_scales(const robot::RobotModel& robot) {
  return each_joint(robot, [](std::size_t /*joint*/) {
    return JointCalibration{0, 1, -kHalfTurn_rad, kHalfTurn_rad};
  });
}

Calibration own_scales(const robot::RobotModel& robot, const Calibration& known) {
  return each_joint(robot, [&](std::size_t joint) {
    const auto& entry = known.joints[joint];
    if (entry) return JointCalibration{0, 1, entry->min_rad, entry->max_rad};
    const double half_rad = (robot.joints[joint].max_rad - robot.joints[joint].min_rad) / 2;
    return JointCalibration{0, 1, -half_rad, half_rad};
  });
}

}  // namespace scarab::bridge::calibrate
