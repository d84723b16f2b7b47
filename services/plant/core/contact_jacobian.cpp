#include "services/plant/core/contact_jacobian.hpp"

#include <algorithm>

namespace scarab::plant {
namespace {

using Eigen::Index;
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
  add_solid(kinematics, contact.a, on_front_trunk(contact.a, leg_on_front), with_trunk, point, -1);
  add_solid(kinematics, contact.b, on_front_trunk(contact.b, leg_on_front), with_trunk, point, 1);
}

void ContactJacobian::add_free_body(std::size_t first_speed, const Vector3d& arm, double sign) {
  free_[free_count_++] = {static_cast<Index>(first_speed), arm, sign};
}

void ContactJacobian::add_hinges(const Kinematics& kinematics, const SolidId& solid, bool on_front,
                                 const Vector3d& point, double sign) {
  const auto add = [&](std::size_t slot) {
    const JointAxis& joint = kinematics.joint[slot];
    hinge_[hinge_count_++] = {static_cast<Index>(kJointSpeed + slot),
                              sign * joint.direction.cross(point - joint.anchor)};
  };
  if (on_front) add(robot::kBackboneSlot);
  const int joints = joints_inboard(solid.solid);
  for (int k = 0; k < joints; ++k) {
    add(joint_slot(robot::kLegs[solid.leg], static_cast<LegJoint>(k)));
  }
}

void ContactJacobian::add_solid(const Kinematics& kinematics, const SolidId& solid, bool on_front,
                                bool with_trunk, const Vector3d& point, double sign) {
  if (solid.body == kWorldBody) return;
  if (!is_robot(solid)) {
    add_free_body(kObjectSpeed, point - kinematics.body[kObjectBody].position, sign);
    return;
  }
  if (with_trunk) {
    add_free_body(kTrunkSpeed, point - kinematics.body[kRearTrunkBody].position, sign);
  }
  add_hinges(kinematics, solid, on_front, point, sign);
}

Vector3d ContactJacobian::velocity(const SpeedVector& speed) const {
  Vector3d out = Vector3d::Zero();
  for (std::size_t i = 0; i < free_count_; ++i) {
    const FreeBody& body = free_[i];
    const Vector3d arm = body.sign * body.arm;
    const Vector3d spin = speed.segment<3>(body.first_speed);
    const Vector3d linear = body.sign * speed.segment<3>(body.first_speed + 3);
    out.x() = out.x() + linear.x() + spin.y() * arm.z() - spin.z() * arm.y();
    out.y() = out.y() - spin.x() * arm.z() + linear.y() + spin.z() * arm.x();
    out.z() = out.z() + spin.x() * arm.y() - spin.y() * arm.x() + linear.z();
  }
  for (std::size_t i = 0; i < hinge_count_; ++i) {
    out += speed(hinge_[i].speed) * hinge_[i].column;
  }
  return out;
}

void ContactJacobian::add_force(const Vector3d& f, SpeedVector& force) const {
  for (std::size_t i = 0; i < free_count_; ++i) {
    const FreeBody& body = free_[i];
    force.segment<3>(body.first_speed) += body.sign * body.arm.cross(f);
    force.segment<3>(body.first_speed + 3) += body.sign * f;
  }
  for (std::size_t i = 0; i < hinge_count_; ++i) force(hinge_[i].speed) += hinge_[i].column.dot(f);
}

/// Entries of one row, on and below the diagonal: `weighted` against the columns of these speeds.
void ContactJacobian::add_row(Index row, const Vector3d& weighted, SpeedMatrix& system) const {
  for (std::size_t i = 0; i < free_count_; ++i) {
    const FreeBody& body = free_[i];
    if (row < body.first_speed) continue;
    Eigen::Matrix<double, 6, 1> entry;
    entry << body.sign * body.arm.cross(weighted), body.sign * weighted;
    const Index count = std::min<Index>(6, row - body.first_speed + 1);
    for (Index k = 0; k < count; ++k) system(row, body.first_speed + k) += entry(k);
  }
  // Two legs on the front trunk both bring a column of the backbone: each meets both.
  for (std::size_t i = 0; i < hinge_count_; ++i) {
    const Hinge& hinge = hinge_[i];
    if (hinge.speed <= row) system(row, hinge.speed) += weighted.dot(hinge.column);
  }
}

void ContactJacobian::add_damping(const Vector3d& n, double normal, double slip,
                                  SpeedMatrix& system) const {
  const auto weighted = [&](const Vector3d& column) -> Vector3d {
    return slip * column + (normal - slip) * n.dot(column) * n;
  };
  for (std::size_t i = 0; i < free_count_; ++i) {
    const FreeBody& body = free_[i];
    for (Index k = 0; k < 3; ++k) {
      const Vector3d axis = body.sign * Vector3d::Unit(k);
      add_row(body.first_speed + k, weighted(axis.cross(body.arm)), system);
      add_row(body.first_speed + 3 + k, weighted(axis), system);
    }
  }
  for (std::size_t i = 0; i < hinge_count_; ++i) {
    add_row(hinge_[i].speed, weighted(hinge_[i].column), system);
  }
}

}  // namespace scarab::plant
