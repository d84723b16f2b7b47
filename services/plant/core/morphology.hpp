#pragma once

#include <Eigen/Dense>
#include <array>

#include "common/robot/robot_model.hpp"
#include "services/plant/core/bodies.hpp"
#include "services/plant/core/plant_config.hpp"

namespace scarab::plant {

/// Where a body hangs on its parent: the child's frame at joint angle 0, and the joint's axis.
struct Mounting {
  std::size_t parent = 0;
  Eigen::Matrix3d R_parent_child = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position_in_parent = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_in_child = Eigen::Vector3d::UnitZ();
  std::size_t joint_slot = 0;
};

/// A leg segment's capsule runs from its body's origin to `tip` (body frame).
struct SegmentShape {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  double radius_m = 0;
};

/// A box of the trunk, in the frame of its body.
struct TrunkBox {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
};

/// A robot and its object laid out as the plant's bodies: how they hang together, weigh and look.
/// Segments are solid rods, the trunk a solid box divided at the hinge, the object a solid
/// cylinder.
struct Morphology {
  std::array<Mounting, kBodyCount> mounting;  ///< of every body but the two free ones
  std::array<BodyMass, kBodyCount> mass;
  std::array<SegmentShape, kBodyCount> segment;  ///< of the 18 leg bodies
  std::array<double, robot::kLegCount> foot_radius_m{};
  std::array<bool, robot::kLegCount> leg_on_front{};  ///< moved by the backbone hinge
  TrunkBox rear_box;
  TrunkBox front_box;
  std::array<robot::Joint, robot::kJointCount> joints;
  double object_radius_m = 0;
  double object_half_length_m = 0;
};

/// Throws std::invalid_argument naming a length, radius or mass that is not positive and finite, or
/// a hinge outside the trunk.
[[nodiscard]] Morphology make_morphology(const robot::RobotModel& robot,
                                         const ObjectConfig& object);

}  // namespace scarab::plant
