#include "services/plant/core/inertial_force.hpp"

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using robot::LegJoint;

/// Of a body's origin.
struct Acceleration {
  Vector3d angular = Vector3d::Zero();
  Vector3d linear = Vector3d::Zero();
};

/// Force, and moment about the trunk's origin.
struct Wrench {
  Vector3d moment = Vector3d::Zero();
  Vector3d force = Vector3d::Zero();

  void add(const Wrench& other) {
    moment += other.moment;
    force += other.force;
  }
};

/// Of a body on a hinge that turns at constant speed: its axis turns with the parent.
Acceleration outwards(const Acceleration& parent, const BodyMotion& from, const BodyMotion& to) {
  const Vector3d arm = to.position - from.position;
  const Vector3d& spin = from.angular_velocity;
  return {parent.angular + spin.cross(to.angular_velocity),
          parent.linear + parent.angular.cross(arm) + spin.cross(spin.cross(arm))};
}

/// What moves the body so: Newton and Euler.
Wrench wrench(const BodyMass& mass, const BodyMotion& body, const Acceleration& acceleration,
              const Vector3d& origin) {
  const Matrix3d& R_world_body = body.R_world_body;
  const Vector3d centre = R_world_body * mass.centre_m;
  const Vector3d& spin = body.angular_velocity;
  Wrench out;
  out.force = mass.mass_kg * (acceleration.linear + acceleration.angular.cross(centre) +
                              spin.cross(spin.cross(centre)));
  const Vector3d spin_body = R_world_body.transpose() * spin;
  const Vector3d turn_body = R_world_body.transpose() * acceleration.angular;
  const Vector3d moment_body =
      mass.inertia_kg_m2 * turn_body + spin_body.cross(mass.inertia_kg_m2 * spin_body);
  out.moment = R_world_body * moment_body + (body.position + centre - origin).cross(out.force);
  return out;
}

double along(const JointAxis& joint, const Wrench& wrench, const Vector3d& origin) {
  return joint.direction.dot(wrench.moment - (joint.anchor - origin).cross(wrench.force));
}

}  // namespace

InertialForce::InertialForce(const Morphology& morphology)
    : mass_(morphology.mass), leg_on_front_(morphology.leg_on_front) {}

void InertialForce::compute(const Kinematics& kinematics, SpeedVector& force) const {
  const auto& body = kinematics.body;
  const BodyMotion& rear = body[kRearTrunkBody];
  const Vector3d& origin = rear.position;
  const Acceleration rear_acceleration;
  const Acceleration front_acceleration = outwards(rear_acceleration, rear, body[kFrontTrunkBody]);
  Wrench on_rear = wrench(mass_[kRearTrunkBody], rear, rear_acceleration, origin);
  Wrench on_front =
      wrench(mass_[kFrontTrunkBody], body[kFrontTrunkBody], front_acceleration, origin);

  for (const robot::Leg leg : robot::kLegs) {
    const bool front = leg_on_front_[robot::leg_slot(leg)];
    std::array<Wrench, 3> segment;
    Acceleration acceleration = front ? front_acceleration : rear_acceleration;
    std::size_t parent = front ? kFrontTrunkBody : kRearTrunkBody;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t child = leg_body(leg, static_cast<LegSegment>(k));
      acceleration = outwards(acceleration, body[parent], body[child]);
      segment[k] = wrench(mass_[child], body[child], acceleration, origin);
      parent = child;
    }
    Wrench sum;
    for (std::size_t k = 3; k-- > 0;) {
      sum.add(segment[k]);
      const std::size_t slot = joint_slot(leg, static_cast<LegJoint>(k));
      force(static_cast<Index>(kJointSpeed + slot)) = along(kinematics.joint[slot], sum, origin);
    }
    (front ? on_front : on_rear).add(sum);
  }
  force(static_cast<Index>(kJointSpeed + robot::kBackboneSlot)) =
      along(kinematics.joint[robot::kBackboneSlot], on_front, origin);
  on_rear.add(on_front);
  force.segment<3>(static_cast<Index>(kTrunkSpeed)) = on_rear.moment;
  force.segment<3>(static_cast<Index>(kTrunkSpeed + 3)) = on_rear.force;

  const BodyMotion& object = body[kObjectBody];
  const Wrench on_object = wrench(mass_[kObjectBody], object, {}, object.position);
  force.segment<3>(static_cast<Index>(kObjectSpeed)) = on_object.moment;
  force.segment<3>(static_cast<Index>(kObjectSpeed + 3)) = on_object.force;
}

}  // namespace scarab::plant
