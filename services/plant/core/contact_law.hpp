#pragma once

#include <vector>

#include "services/plant/core/contact.hpp"
#include "services/plant/core/plant_config.hpp"

namespace scarab::plant {

/// Coefficients of one contact's force, linear in the relative velocity v = v_b - v_a at the
/// contact point at the END of a step of length dt:
///
///   F_on_b = normal (push - normal_damping v.n) + anchor - slip_damping (v - (v.n) n)
///
/// push = k d, normal_damping = c + dt k: penalty spring and damper, the spring at the end of the
/// step. slip_damping = mu N / max(|v_t|, v_s): Coulomb friction regularised below v_s, as the
/// secant through the present slip speed (so it never reverses a slip), with N the normal force
/// expected from the present velocity. With anchors (Cundall and Strack 1979) a spring of the slip
/// since touch-down is added below the Coulomb limit.
struct ContactForce {
  double push_n = 0;
  double normal_damping = 0;
  double slip_damping = 0;
  Eigen::Vector3d anchor_n = Eigen::Vector3d::Zero();
  double rolling_damping = 0;  ///< N m s: torque on the object along its axis, against its spin
};

/// The force on solid b at relative velocity `velocity`, by the formula above.
[[nodiscard]] Eigen::Vector3d force_on_b(const ContactForce& law, const Eigen::Vector3d& normal,
                                         const Eigen::Vector3d& velocity);

/// Friction coefficient of a pair, solid_a <= solid_b.
[[nodiscard]] double friction_coefficient(const FrictionConfig& friction, Solid a, Solid b);

/// The contact law and its one memory, the friction anchors.
class ContactLaw {
 public:
  ContactLaw(const ContactConfig& contact, const FrictionConfig& friction);

  /// Force of `contact` for a step of dt_s, given the relative velocity (m/s, b against a) and the
  /// object's spin about its axis (rad/s). A contact that would pull gives zeros.
  [[nodiscard]] ContactForce evaluate(const Contact& contact, const Eigen::Vector3d& velocity,
                                      double object_spin_rad_s, double object_radius_m,
                                      double dt_s);

  /// Call once before the contacts of each step are evaluated.
  void begin_step() { ++step_; }

 private:
  struct Anchor {
    std::uint64_t step = 0;  ///< of the last use; older: the contact was open in between
    Eigen::Vector3d stretch = Eigen::Vector3d::Zero();
  };

  void add_friction(const Contact& contact, const Eigen::Vector3d& slip, double normal_n,
                    double dt_s, ContactForce& force);

  ContactConfig contact_;
  FrictionConfig friction_;
  std::vector<Anchor> anchors_;
  std::uint64_t step_ = 1;
};

}  // namespace scarab::plant
