#include "services/plant/core/contact_jacobian.hpp"

namespace scarab::plant {
namespace {

using Eigen::Vector3d;
using robot::LegJoint;

bool is_robot(const SolidId& solid) { return solid.body < kObjectBody; }

bool on_front_trunk(const SolidId& solid, const std::array<bool, robot::kLegCount>& leg_on_front) {
  if (solid.solid == Solid::kTrunk) return solid.body == kFrontTrunkBody;
  return leg_on_front[solid.leg];
}

/// How many of its leg's joints move the solid.
int joints_inboard(Solid solid) {
  switch (solid) {
    case Solid::kCoxa:
      return 1;
    case Solid::kFemur:
      return 2;
    case Solid::kTibia:
    case Solid::kFoot:
      return 3;
    default:
      return 0;
  }
}

}  // namespace

ContactJacobian::ContactJacobian(const Kinematics& kinematics,
                                 const std::array<bool, robot::kLegCount>& leg_on_front,
                                 const Contact& contact) {
  const bool with_trunk = !(is_robot(contact.a) && is_robot(contact.b));
  const Vector3d& point = contact.touch.point;
  add_body(kinematics, contact.a, on_front_trunk(contact.a, leg_on_front), with_trunk, point, -1);
  add_body(kinematics, contact.b, on_front_trunk(contact.b, leg_on_front), with_trunk, point, 1);
}

void ContactJacobian::add_column(std::size_t speed, const Vector3d& column) {
  speed_[count_] = static_cast<Eigen::Index>(speed);
  column_[count_++] = column;
}

void ContactJacobian::add_body(const Kinematics& kinematics, const SolidId& solid, bool on_front,
                               bool with_trunk, const Vector3d& point, double sign) {
  if (solid.body == kWorldBody) return;
  const bool robot = is_robot(solid);
  if (!robot || with_trunk) {
    const std::size_t first = robot ? kTrunkSpeed : kObjectSpeed;
    const Vector3d arm = point - kinematics.body[robot ? kRearTrunkBody : kObjectBody].position;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      add_column(first + axis, sign * Vector3d::Unit(k).cross(arm));
      add_column(first + 3 + axis, sign * Vector3d::Unit(k));
    }
  }
  if (!robot) return;
  const auto add_joint = [&](std::size_t slot) {
    const JointAxis& joint = kinematics.joint[slot];
    add_column(kJointSpeed + slot, sign * joint.direction.cross(point - joint.anchor));
  };
  if (on_front) add_joint(robot::kBackboneSlot);
  const int joints = joints_inboard(solid.solid);
  for (int k = 0; k < joints; ++k) {
    add_joint(joint_slot(robot::kLegs[solid.leg], static_cast<LegJoint>(k)));
  }
}

Vector3d ContactJacobian::velocity(const SpeedVector& speed) const {
  Vector3d out = Vector3d::Zero();
  for (std::size_t i = 0; i < count_; ++i) out += speed(speed_[i]) * column_[i];
  return out;
}

void ContactJacobian::add_force(const Vector3d& f, SpeedVector& force) const {
  for (std::size_t i = 0; i < count_; ++i) force(speed_[i]) += column_[i].dot(f);
}

void ContactJacobian::add_damping(const Vector3d& n, double normal, double slip,
                                  SpeedMatrix& system) const {
  for (std::size_t i = 0; i < count_; ++i) {
    const Vector3d weighted = slip * column_[i] + (normal - slip) * n.dot(column_[i]) * n;
    const Eigen::Index row = speed_[i];
    for (std::size_t j = 0; j < count_; ++j) {
      // Each unordered pair of speeds once: only the entry below the diagonal is kept.
      if (speed_[j] <= row) system(row, speed_[j]) += weighted.dot(column_[j]);
    }
  }
}

}  // namespace scarab::plant
