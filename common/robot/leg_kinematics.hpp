#pragma once

#include <Eigen/Core>
#include <array>

#include "common/robot/joints.hpp"
#include "common/robot/robot_model.hpp"

/// Forward kinematics of a leg: pure geometry of the robot file.
///
/// From the mount outwards every segment lies along the leg's own axis, +y on the left and -y on
/// the right (side s = +1, -1), in the frame
///     R_trunk_tibia = Rz(-s yaw) Rx(s elevation) Ry(rotation) Rz(-s T) Rx(s C) Rx(-s F)
/// with the shoulder before the T rotation, the coxa after it, the femur after C, the tibia after
/// F.
namespace scarab::robot {

/// Angles of one leg's joints (rad): T + forward, C + up, F + flexion (down).
struct LegAngles {
  double t_rad = 0;
  double c_rad = 0;
  double f_rad = 0;
};

/// Angles of one leg out of a whole robot's; absent joints count as 0.
[[nodiscard]] LegAngles leg_angles(const RobotModel& model, Leg leg, const JointVector& joints_rad);

/// Ends of a leg's segments from the trunk outwards (m): mount, thoraco-coxal joint,
/// coxa-trochanteral joint, femur-tibia joint, centre of the foot sphere. Frame: the undivided
/// trunk's centre, x forward, y left, z up. For a leg on the front segment this holds at backbone
/// angle 0.
[[nodiscard]] std::array<Eigen::Vector3d, 5> leg_points_m(const RobotModel& model, Leg leg,
                                                          const LegAngles& angles);

/// Centre of the foot sphere (m), the last of leg_points_m().
[[nodiscard]] Eigen::Vector3d foot_position_m(const RobotModel& model, Leg leg,
                                              const LegAngles& angles);

}  // namespace scarab::robot
