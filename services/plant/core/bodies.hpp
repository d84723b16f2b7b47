#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstddef>

#include "common/robot/joints.hpp"

/// The plant's bodies and generalised speeds in one fixed order, whatever the robot lacks: a joint
/// the robot does not have keeps its slot and is locked at 0.
namespace scarab::plant {

enum class LegSegment : std::size_t { kCoxa, kFemur, kTibia };

inline constexpr std::size_t kRearTrunkBody =
    0;  ///< free body; origin at the undivided trunk's centre
inline constexpr std::size_t kFrontTrunkBody = 1;  ///< origin at the backbone hinge
inline constexpr std::size_t kObjectBody = 20;
inline constexpr std::size_t kBodyCount = 21;

/// Body of a leg segment; its origin is the joint that moves it, at angle 0 its axes are the
/// mount's.
constexpr std::size_t leg_body(robot::Leg leg, LegSegment segment) {
  return 2 + 3 * robot::leg_slot(leg) + static_cast<std::size_t>(segment);
}

/// Generalised speeds: angular then linear velocity of the rear trunk's origin (world frame), the
/// 19 joint speeds in slot order, angular then linear velocity of the object's centre (world
/// frame).
inline constexpr std::size_t kTrunkSpeed = 0;
inline constexpr std::size_t kJointSpeed = 6;
inline constexpr std::size_t kObjectSpeed = kJointSpeed + robot::kJointCount;
inline constexpr std::size_t kSpeedCount = kObjectSpeed + 6;

using SpeedVector = Eigen::Matrix<double, kSpeedCount, 1>;
using SpeedMatrix = Eigen::Matrix<double, kSpeedCount, kSpeedCount>;

/// Everything the equations of motion integrate.
struct MotionState {
  Eigen::Vector3d trunk_position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond trunk_orientation = Eigen::Quaterniond::Identity();
  robot::JointVector joint_rad{};
  Eigen::Vector3d object_position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond object_orientation = Eigen::Quaterniond::Identity();
  SpeedVector speed = SpeedVector::Zero();
};

/// Pose and velocity of one body in the world, at its origin.
struct BodyMotion {
  Eigen::Matrix3d R_world_body = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();

  [[nodiscard]] Eigen::Vector3d to_world(const Eigen::Vector3d& point_body) const {
    return position + R_world_body * point_body;
  }
};

/// A joint's axis in the world; positive speed turns the child about it.
struct JointAxis {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
};

struct Kinematics {
  std::array<BodyMotion, kBodyCount> body;
  std::array<JointAxis, robot::kJointCount> joint;
};

/// Mass properties of one body in its own frame.
struct BodyMass {
  double mass_kg = 0;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();  ///< about the centre of mass
};

}  // namespace scarab::plant
