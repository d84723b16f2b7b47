#include "services/plant/core/mass_matrix.hpp"

namespace scarab::plant {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using robot::LegJoint;

/// Spatial inertia about the trunk's origin, world axes.
struct SpatialInertia {
  double mass = 0;
  Vector3d first_moment = Vector3d::Zero();
  Matrix3d inertia = Matrix3d::Zero();

  void add(const SpatialInertia& other) {
    mass += other.mass;
    first_moment += other.first_moment;
    inertia += other.inertia;
  }
};

/// Spatial velocity or momentum about the trunk's origin.
struct Spatial {
  Vector3d angular;
  Vector3d linear;
};

double dot(const Spatial& a, const Spatial& b) {
  return a.angular.dot(b.angular) + a.linear.dot(b.linear);
}

SpatialInertia about(const Vector3d& origin, const BodyMotion& body, const BodyMass& mass) {
  const Vector3d centre = body.to_world(mass.centre_m) - origin;
  SpatialInertia out;
  out.mass = mass.mass_kg;
  out.first_moment = mass.mass_kg * centre;
  out.inertia.noalias() = body.R_world_body * mass.inertia_kg_m2 * body.R_world_body.transpose();
  out.inertia.diagonal().array() += mass.mass_kg * centre.squaredNorm();
  out.inertia.noalias() -= out.first_moment * centre.transpose();
  return out;
}

Spatial subspace(const JointAxis& joint, const Vector3d& origin) {
  return {joint.direction, (joint.anchor - origin).cross(joint.direction)};
}

Spatial momentum(const SpatialInertia& body, const Spatial& velocity) {
  return {body.inertia * velocity.angular + body.first_moment.cross(velocity.linear),
          body.mass * velocity.linear + velocity.angular.cross(body.first_moment)};
}

void set_free_body(const SpatialInertia& body, std::size_t speed, SpeedMatrix& mass) {
  const auto at = static_cast<Eigen::Index>(speed);
  const Vector3d& h = body.first_moment;
  mass.block<3, 3>(at, at) = body.inertia;
  mass.block<3, 3>(at + 3, at + 3) = body.mass * Matrix3d::Identity();
  mass.block<3, 3>(at + 3, at) << 0, h.z(), -h.y(), -h.z(), 0, h.x(), h.y(), -h.x(), 0;
}

void set_free_weight(const SpatialInertia& body, double g, std::size_t speed,
                     SpeedVector& gravity) {
  const auto at = static_cast<Eigen::Index>(speed);
  const Vector3d weight(0, 0, -g);
  gravity.segment<3>(at) = body.first_moment.cross(weight);
  gravity.segment<3>(at + 3) = body.mass * weight;
}

/// One joint on a path towards the trunk.
struct PathJoint {
  Eigen::Index speed;
  Spatial subspace;
};

/// Writes row (or column, below the diagonal) of the joint `path[count - 1]`, which moves
/// `composite`.
void set_joint(const SpatialInertia& composite, const PathJoint* path, int count, double g,
               SpeedMatrix& mass, SpeedVector& gravity) {
  const PathJoint& joint = path[count - 1];
  const Spatial p = momentum(composite, joint.subspace);
  mass.block<1, 3>(joint.speed, 0) = p.angular.transpose();
  mass.block<1, 3>(joint.speed, 3) = p.linear.transpose();
  for (int i = 0; i < count; ++i) {
    const Eigen::Index row = std::max(joint.speed, path[i].speed);
    const Eigen::Index column = std::min(joint.speed, path[i].speed);
    mass(row, column) = dot(path[i].subspace, p);
  }
  gravity(joint.speed) = -g * p.linear.z();
}

PathJoint path_joint(const Kinematics& kinematics, std::size_t slot, const Vector3d& origin) {
  return {static_cast<Eigen::Index>(kJointSpeed + slot), subspace(kinematics.joint[slot], origin)};
}

}  // namespace

MassMatrix::MassMatrix(const Morphology& morphology)
    : mass_(morphology.mass), leg_on_front_(morphology.leg_on_front) {}

void MassMatrix::compute(const Kinematics& kinematics, double gravity_m_s2, SpeedMatrix& mass,
                         SpeedVector& gravity) const {
  const auto& body = kinematics.body;
  const Vector3d origin = body[kRearTrunkBody].position;
  mass.setZero();
  SpatialInertia rear = about(origin, body[kRearTrunkBody], mass_[kRearTrunkBody]);
  SpatialInertia front = about(origin, body[kFrontTrunkBody], mass_[kFrontTrunkBody]);
  const PathJoint backbone = path_joint(kinematics, robot::kBackboneSlot, origin);

  for (const robot::Leg leg : robot::kLegs) {
    const bool on_front = leg_on_front_[robot::leg_slot(leg)];
    PathJoint path[4];
    int count = 0;
    if (on_front) path[count++] = backbone;
    for (const LegJoint joint :
         {LegJoint::kThoracoCoxal, LegJoint::kCoxaTrochanteral, LegJoint::kFemurTibia}) {
      path[count++] = path_joint(kinematics, joint_slot(leg, joint), origin);
    }
    SpatialInertia composite;
    for (const LegSegment segment : {LegSegment::kTibia, LegSegment::kFemur, LegSegment::kCoxa}) {
      const std::size_t index = leg_body(leg, segment);
      composite.add(about(origin, body[index], mass_[index]));
      set_joint(composite, path, count--, gravity_m_s2, mass, gravity);
    }
    (on_front ? front : rear).add(composite);
  }
  set_joint(front, &backbone, 1, gravity_m_s2, mass, gravity);
  rear.add(front);
  set_free_body(rear, kTrunkSpeed, mass);
  set_free_weight(rear, gravity_m_s2, kTrunkSpeed, gravity);

  const SpatialInertia object =
      about(body[kObjectBody].position, body[kObjectBody], mass_[kObjectBody]);
  set_free_body(object, kObjectSpeed, mass);
  set_free_weight(object, gravity_m_s2, kObjectSpeed, gravity);
}

}  // namespace scarab::plant
