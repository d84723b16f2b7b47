#pragma once

#include <bitset>
#include <cstdint>
#include <vector>

#include "services/plant/core/branch_solver.hpp"
#include "services/plant/core/collision.hpp"
#include "services/plant/core/contact_jacobian.hpp"
#include "services/plant/core/contact_law.hpp"
#include "services/plant/core/forward_kinematics.hpp"
#include "services/plant/core/inertial_force.hpp"
#include "services/plant/core/mass_matrix.hpp"
#include "services/plant/core/servo.hpp"
#include "services/plant/core/simbody_check.hpp"

namespace scarab::plant {

/// A contact and the force it had over the last step, on solid b, N.
struct ResolvedContact {
  Contact contact;
  Eigen::Vector3d force_n = Eigen::Vector3d::Zero();
  double normal_n = 0;
};

/// One step of the linearly implicit Euler method:
///
///   (M + armature + dt D + dt^2 K) du = dt f,   u += du,   q += dt u
///
/// f: gravity, inertial, servo, stop and contact forces at the present positions and at velocities
/// that include dt K; D, K: damping and stiffness of servos, stops, normal contact, friction
/// (secant slope, lagged normal force) and rolling resistance, through their Jacobians. Solved leg
/// by leg; orientations follow the exponential map. Stable for contact stiffnesses an explicit
/// method would need 20 us for.
///
/// Kinematics, M and inertial forces are written out for this tree; every kStepsPerCheck steps,
/// the first among them, they are held against Simbody's.
class Stepper {
 public:
  Stepper(const Morphology& morphology, const PlantConfig& config, const Wall& wall);

  /// Advances `state` by dt_s; servos slew `reference_rad` towards `targets_rad` on the way. Throws
  /// std::logic_error if the tree's dynamics are not those of Simbody's model.
  void step(const robot::JointVector& targets_rad, double dt_s, robot::JointVector& reference_rad,
            MotionState& state);

  /// From the next step on only servos with power give a torque; all have it at the start. One
  /// without is dragged along by its joint, and its reference with it, so that it begins where the
  /// joint is when its power comes back.
  void power(const std::bitset<robot::kJointCount>& powered) { powered_ = powered; }

  /// Of the last step. Forces are those that acted over it.
  [[nodiscard]] const std::vector<ResolvedContact>& contacts() const { return resolved_; }
  [[nodiscard]] const robot::JointVector& servo_torque_nm() const { return servo_torque_; }
  [[nodiscard]] const SpeedVector& acceleration() const { return acceleration_; }

 private:
  void add_joints(const robot::JointVector& targets_rad, double dt_s,
                  robot::JointVector& reference_rad, const MotionState& state);
  void add_contacts(double dt_s);
  void resolve();
  void lock_absent_joints();

  static constexpr std::uint64_t kStepsPerCheck = 500;

  Morphology morphology_;
  PlantConfig config_;
  ForwardKinematics forward_kinematics_;
  MassMatrix mass_matrix_;
  InertialForce inertial_force_;
  SimbodyCheck simbody_check_;
  BranchSolver solver_;
  Collision collision_;
  ContactLaw contact_law_;

  std::bitset<robot::kJointCount> powered_ = std::bitset<robot::kJointCount>().set();

  // Scratch, kept to avoid allocation.
  Kinematics kinematics_;
  SpeedMatrix system_;
  SpeedVector speed_, force_, inertial_;
  std::uint64_t step_ = 0;
  std::vector<Contact> found_;
  std::vector<ContactJacobian> jacobians_;
  std::vector<ContactForce> laws_;
  std::vector<ResolvedContact> resolved_;
  std::array<JointTorque, robot::kJointCount> servo_{};
  robot::JointVector servo_torque_{};
  SpeedVector acceleration_ = SpeedVector::Zero();
};

/// Moves positions and orientations along state.speed for dt_s.
void integrate_position(MotionState& state, double dt_s);

}  // namespace scarab::plant
