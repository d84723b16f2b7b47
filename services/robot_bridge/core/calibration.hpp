#pragma once

#include <array>
#include <optional>

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"

/// From the angles of joints to those of servos and back.
///
/// The servo's angle is that of its own scale, in rad, growing as the value grows that the servo is
/// told; 0 is the middle of that scale (the driver says which value that is). A servo is mounted as
/// its bracket lets it be, so its scale stands off the joint's by `offset_rad` and may run the
/// other way:
///
///     servo = offset + direction * joint
namespace scarab::bridge {

/// How one servo sits in its joint.
struct JointCalibration {
  double offset_rad = 0;  ///< the servo's angle where the joint's is 0
  int direction = 1;      ///< +1 or -1: which way the servo turns as the joint's angle grows
  /// The ends of the servo's travel, on its own scale: no goal lies beyond. For a board that takes
  /// fractions of a travel instead of angles they are what -1 and +1 stand for.
  double min_rad = 0;
  double max_rad = 0;
};

/// Every joint slot; none where the robot lacks the joint.
struct Calibration {
  std::array<std::optional<JointCalibration>, robot::kJointCount> joints;
};

/// The servo's angle for a joint's, ended at the servo's range.
[[nodiscard]] double to_servo_rad(const JointCalibration& c, double joint_rad) noexcept;

/// The joint's angle for a servo's, wherever that lies: a measurement is never ended.
[[nodiscard]] double to_joint_rad(const JointCalibration& c, double servo_rad) noexcept;

/// The joint's speed or torque for its servo's, and the other way round.
[[nodiscard]] double turned(const JointCalibration& c, double value) noexcept;

/// An interval of a joint's angles.
struct JointRange {
  double min_rad = 0;
  double max_rad = 0;
};

/// The joint's angles that its servo can reach.
[[nodiscard]] JointRange reach(const JointCalibration& c) noexcept;

/// That of the joints that the robot has. Throws std::invalid_argument naming the joint if one has
/// none.
[[nodiscard]] Calibration of_robot(const Calibration& c, const robot::RobotModel& robot);

/// The robot with the range of each joint cut to what its servo can reach, so that the command gate
/// clamps, counts and reports what the servo could not do. A range may come out empty (min above
/// max); joints without a calibration stay as they are.
[[nodiscard]] robot::RobotModel within_reach(robot::RobotModel robot, const Calibration& c);

}  // namespace scarab::bridge
