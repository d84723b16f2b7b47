#include "services/plant/core/stepper.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr Index kObjectSpin = static_cast<Index>(kObjectSpeed);

/// More than a robot that climbs over the object ever had at once; memory for more is taken when
/// they come.
constexpr std::size_t kContactsUsual = 64;

Index joint_speed(std::size_t slot) { return static_cast<Index>(kJointSpeed + slot); }

Eigen::Quaterniond turned(const Eigen::Quaterniond& orientation, const Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0) return orientation;
  return (Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * orientation).normalized();
}

}  // namespace

void integrate_position(MotionState& state, double dt_s) {
  const auto part = [&state](std::size_t at) -> Vector3d {
    return state.speed.segment<3>(static_cast<Index>(at));
  };
  state.trunk_orientation = turned(state.trunk_orientation, dt_s * part(kTrunkSpeed));
  state.trunk_position += dt_s * part(kTrunkSpeed + 3);
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    state.joint_rad[j] += dt_s * state.speed(joint_speed(j));
  }
  state.object_orientation = turned(state.object_orientation, dt_s * part(kObjectSpeed));
  state.object_position += dt_s * part(kObjectSpeed + 3);
}

Stepper::Stepper(const Morphology& morphology, const PlantConfig& config, const Wall& wall)
    : morphology_(morphology),
      config_(config),
      forward_kinematics_(morphology),
      mass_matrix_(morphology),
      inertial_force_(morphology),
      simbody_check_(morphology),
      collision_(morphology, wall, config.contact.trunk_edge_radius_m),
      contact_law_(config.contact, config.friction) {
  found_.reserve(kContactsUsual);
  jacobians_.reserve(kContactsUsual);
  laws_.reserve(kContactsUsual);
  resolved_.reserve(kContactsUsual);
}

void Stepper::add_joints(const robot::JointVector& targets_rad, double dt_s,
                         robot::JointVector& reference_rad, const MotionState& state) {
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    const robot::Joint& joint = morphology_.joints[j];
    if (!joint.present) continue;
    const Index at = joint_speed(j);
    const double speed = state.speed(at);
    if (powered_[j]) {
      reference_rad[j] = slew(joint, reference_rad[j], targets_rad[j], dt_s);
      servo_[j] = servo_torque(joint, reference_rad[j], state.joint_rad[j], speed, dt_s);
    } else {
      reference_rad[j] = state.joint_rad[j];
      servo_[j] = gear_drag(joint);
    }
    const JointTorque stop =
        stop_torque(config_.joint_stop, joint, state.joint_rad[j], speed, dt_s);
    const double damping = servo_[j].damping_nm_s_rad + stop.damping_nm_s_rad;
    force_(at) += servo_[j].torque_nm + stop.torque_nm - damping * speed;
    system_(at, at) += joint.armature_kg_m2 + dt_s * damping;
  }
}

void Stepper::add_contacts(double dt_s) {
  const Vector3d axis = kinematics_.body[kObjectBody].R_world_body.col(1);
  const double spin = kinematics_.body[kObjectBody].angular_velocity.dot(axis);
  contact_law_.begin_step();
  solver_.begin();
  laws_.clear();
  jacobians_.clear();
  for (const Contact& contact : found_) {
    const ContactJacobian& jacobian =
        jacobians_.emplace_back(kinematics_, morphology_.leg_on_front, contact);
    const Vector3d velocity = jacobian.velocity(speed_);
    const ContactForce law =
        contact_law_.evaluate(contact, velocity, spin, morphology_.object_radius_m, dt_s);
    laws_.push_back(law);
    if (law.push_n <= 0) continue;
    solver_.couple(contact.a, contact.b);
    jacobian.add_force(force_on_b(law, contact.touch.normal, velocity), force_);
    jacobian.add_damping(contact.touch.normal, dt_s * law.normal_damping, dt_s * law.slip_damping,
                         system_);
    if (law.rolling_damping > 0) {
      force_.segment<3>(kObjectSpin) -= law.rolling_damping * spin * axis;
      system_.block<3, 3>(kObjectSpin, kObjectSpin) +=
          dt_s * law.rolling_damping * axis * axis.transpose();
    }
  }
}

void Stepper::lock_absent_joints() {
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (morphology_.joints[j].present) continue;
    const Index at = joint_speed(j);
    system_.row(at).setZero();
    system_.col(at).setZero();
    system_(at, at) = 1;
    force_(at) = 0;
  }
}

void Stepper::resolve() {
  resolved_.clear();
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const ContactForce& law = laws_[i];
    if (law.push_n <= 0) continue;
    const Vector3d& n = found_[i].touch.normal;
    const Vector3d force = force_on_b(law, n, jacobians_[i].velocity(speed_));
    resolved_.push_back({found_[i], force, force.dot(n)});
  }
}

void Stepper::step(const robot::JointVector& targets_rad, double dt_s,
                   robot::JointVector& reference_rad, MotionState& state) {
  speed_ = state.speed;
  forward_kinematics_.update(state, kinematics_);
  mass_matrix_.compute(kinematics_, config_.gravity_m_s2, system_, force_);
  inertial_force_.compute(kinematics_, inertial_);
  if (step_++ % kStepsPerCheck == 0) {
    simbody_check_.compare(state, kinematics_, system_, inertial_, acceleration_);
  }
  force_ -= inertial_;
  add_joints(targets_rad, dt_s, reference_rad, state);
  collision_.detect(kinematics_, found_);
  add_contacts(dt_s);
  lock_absent_joints();

  solver_.factor(system_);
  acceleration_ = solver_.solve(force_);
  speed_ += dt_s * acceleration_;
  state.speed = speed_;
  resolve();
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    // What a servo tells comes from its current, and without power there is none.
    servo_torque_[j] =
        powered_[j] ? servo_[j].torque_nm - servo_[j].damping_nm_s_rad * speed_(joint_speed(j)) : 0;
  }
  integrate_position(state, dt_s);
}

}  // namespace scarab::plant
