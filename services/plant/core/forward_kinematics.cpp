#include "services/plant/core/forward_kinematics.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

void place_free(const Vector3d& position, const Eigen::Quaterniond& orientation,
                const SpeedVector& speed, std::size_t first_speed, BodyMotion& body) {
  const auto at = static_cast<Index>(first_speed);
  body.R_world_body = orientation.toRotationMatrix();
  body.position = position;
  body.angular_velocity = speed.segment<3>(at);
  body.velocity = speed.segment<3>(at + 3);
}

}  // namespace

ForwardKinematics::Hinge ForwardKinematics::hinge(const Mounting& mounting) {
  Hinge out;
  out.parent = mounting.parent;
  out.slot = mounting.joint_slot;
  out.R_parent_child = mounting.R_parent_child;
  out.straight = mounting.R_parent_child == Matrix3d::Identity();
  out.position_in_parent = mounting.position_in_parent;
  mounting.axis_in_child.cwiseAbs().maxCoeff(&out.axis);
  out.sign = mounting.axis_in_child(out.axis) < 0 ? -1 : 1;
  if (mounting.axis_in_child != out.sign * Vector3d::Unit(out.axis)) {
    throw std::invalid_argument("joint " + std::string(robot::kJointNames[out.slot]) +
                                " does not turn about an axis of its body");
  }
  return out;
}

ForwardKinematics::ForwardKinematics(const Morphology& morphology) {
  for (std::size_t i = kFrontTrunkBody; i < kObjectBody; ++i) {
    hinge_[i] = hinge(morphology.mounting[i]);
  }
}

void ForwardKinematics::hang(const Hinge& hinge, double angle_rad, double speed_rad_s,
                             const BodyMotion& parent, BodyMotion& child, JointAxis& joint) {
  Matrix3d& R_world_child = child.R_world_body;
  if (hinge.straight) {
    R_world_child = parent.R_world_body;
  } else {
    R_world_child.noalias() = parent.R_world_body.lazyProduct(hinge.R_parent_child);
  }
  const double cosine = std::cos(angle_rad);
  const double sine = hinge.sign * std::sin(angle_rad);
  const int first = (hinge.axis + 1) % 3;
  const int second = (hinge.axis + 2) % 3;
  const Vector3d before = R_world_child.col(first);
  R_world_child.col(first) = cosine * before + sine * R_world_child.col(second);
  R_world_child.col(second) = cosine * R_world_child.col(second) - sine * before;

  const Vector3d arm = parent.R_world_body * hinge.position_in_parent;
  child.position = parent.position + arm;
  joint.direction = hinge.sign * R_world_child.col(hinge.axis);
  joint.anchor = child.position;
  child.angular_velocity = parent.angular_velocity + speed_rad_s * joint.direction;
  child.velocity = parent.velocity + parent.angular_velocity.cross(arm);
}

void ForwardKinematics::update(const MotionState& state, Kinematics& kinematics) const {
  auto& body = kinematics.body;
  place_free(state.trunk_position, state.trunk_orientation, state.speed, kTrunkSpeed,
             body[kRearTrunkBody]);
  place_free(state.object_position, state.object_orientation, state.speed, kObjectSpeed,
             body[kObjectBody]);
  for (std::size_t i = kFrontTrunkBody; i < kObjectBody; ++i) {
    const Hinge& hinge = hinge_[i];
    hang(hinge, state.joint_rad[hinge.slot],
         state.speed(static_cast<Index>(kJointSpeed + hinge.slot)), body[hinge.parent], body[i],
         kinematics.joint[hinge.slot]);
  }
}

}  // namespace scarab::plant
