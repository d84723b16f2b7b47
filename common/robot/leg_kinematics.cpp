#include "common/robot/leg_kinematics.hpp"

#include <Eigen/Geometry>

namespace scarab::robot {
namespace {

Eigen::Matrix3d about(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

}  // namespace

LegAngles leg_angles(const RobotModel& model, Leg leg, const JointVector& joints_rad) {
  const auto angle = [&](LegJoint joint) {
    const std::size_t slot = joint_slot(leg, joint);
    return model.joints[slot].present ? joints_rad[slot] : 0.0;
  };
  return {angle(LegJoint::kThoracoCoxal), angle(LegJoint::kCoxaTrochanteral),
          angle(LegJoint::kFemurTibia)};
}

std::array<Eigen::Vector3d, 5> leg_points_m(const RobotModel& model, Leg leg,
                                            const LegAngles& angles) {
  const LegRow& row = model.rows[robot::row(leg)];
  const double side = is_left(leg) ? 1.0 : -1.0;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d outwards = side * y;

  const Eigen::Matrix3d R_trunk_shoulder = about(z, -side * row.mount_yaw_rad) *
                                           about(x, side * row.mount_elevation_rad) *
                                           about(y, row.mount_rotation_rad);
  const Eigen::Matrix3d R_trunk_coxa = R_trunk_shoulder * about(z, -side * angles.t_rad);
  const Eigen::Matrix3d R_trunk_femur = R_trunk_coxa * about(x, side * angles.c_rad);
  const Eigen::Matrix3d R_trunk_tibia = R_trunk_femur * about(x, -side * angles.f_rad);

  std::array<Eigen::Vector3d, 5> points;
  points[0] = {row.attachment_m[0], side * row.attachment_m[1], row.attachment_m[2]};
  points[1] = points[0] + R_trunk_shoulder * outwards * row.shoulder.length_m;
  points[2] = points[1] + R_trunk_coxa * outwards * row.coxa.length_m;
  points[3] = points[2] + R_trunk_femur * outwards * row.femur.length_m;
  points[4] = points[3] + R_trunk_tibia * outwards * row.tibia.length_m;
  return points;
}

Eigen::Vector3d foot_position_m(const RobotModel& model, Leg leg, const LegAngles& angles) {
  return leg_points_m(model, leg, angles).back();
}

}  // namespace scarab::robot
