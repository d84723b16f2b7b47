#include "services/plant/core/contact_law.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::plant {
namespace {

/// Points along the cylinder's axis share its stiffness.
constexpr double kObjectPoints = 3;

bool grips(Solid solid) { return solid == Solid::kTibia || solid == Solid::kFoot; }
bool is_robot(Solid solid) { return solid >= Solid::kTrunk; }

}  // namespace

Eigen::Vector3d force_on_b(const ContactForce& law, const Eigen::Vector3d& normal,
                           const Eigen::Vector3d& velocity) {
  const double separation = velocity.dot(normal);
  return (law.push_n - law.normal_damping * separation) * normal + law.anchor_n -
         law.slip_damping * (velocity - separation * normal);
}

double friction_coefficient(const FrictionConfig& friction, Solid a, Solid b) {
  if (is_leg(a) && is_leg(b)) return friction.leg_leg;
  if (a == Solid::kGround) {
    if (b == Solid::kObject) return friction.object_ground;
    return grips(b) ? friction.foot_ground : friction.trunk_ground;
  }
  if (a == Solid::kObject) {
    if (b == Solid::kObstacle) return friction.object_obstacle;
    return grips(b) ? friction.foot_object : friction.trunk_object;
  }
  return friction.leg_obstacle;
}

ContactLaw::ContactLaw(const ContactConfig& contact, const FrictionConfig& friction)
    : contact_(contact), friction_(friction) {
  if (contact.anchor_stiffness_n_m > 0) anchors_.resize(kFeatureCount);
}

ContactForce ContactLaw::evaluate(const Contact& contact, const Eigen::Vector3d& velocity,
                                  double object_spin_rad_s, double object_radius_m, double dt_s) {
  const bool shared = !is_robot(contact.b.solid);
  const NormalContact& normal = shared ? contact_.object : contact_.robot;
  const double share = shared ? 1 / kObjectPoints : 1;
  ContactForce force;
  const double separation = velocity.dot(contact.touch.normal);
  force.push_n = share * normal.stiffness_n_m * contact.touch.depth;
  force.normal_damping = share * (normal.damping_n_s_m + dt_s * normal.stiffness_n_m);
  const double expected_n = force.push_n - force.normal_damping * separation;
  if (expected_n <= 0) return {};
  add_friction(contact, velocity - separation * contact.touch.normal, expected_n, dt_s, force);
  if (contact.a.solid == Solid::kGround && contact.b.solid == Solid::kObject) {
    const double slow = contact_.slip_speed_m_s / object_radius_m;
    force.rolling_damping = contact_.object_rolling_resistance_m * expected_n /
                            std::max(std::abs(object_spin_rad_s), slow);
  }
  return force;
}

void ContactLaw::add_friction(const Contact& contact, const Eigen::Vector3d& slip, double normal_n,
                              double dt_s, ContactForce& force) {
  const double limit = friction_coefficient(friction_, contact.a.solid, contact.b.solid) * normal_n;
  const double speed = slip.norm();
  force.slip_damping = limit / std::max(speed, contact_.slip_speed_m_s);
  if (anchors_.empty()) return;
  Anchor& anchor = anchors_[contact.feature];
  if (anchor.step + 1 < step_) anchor.stretch.setZero();
  anchor.step = step_;
  const Eigen::Vector3d& n = contact.touch.normal;
  anchor.stretch += dt_s * slip;
  anchor.stretch -= anchor.stretch.dot(n) * n;
  const double stretched = contact_.anchor_stiffness_n_m * anchor.stretch.norm();
  // The anchor holds up to the Coulomb limit and then drags along; what is left goes to the slip.
  if (stretched > limit) anchor.stretch *= limit / stretched;
  force.anchor_n = -contact_.anchor_stiffness_n_m * anchor.stretch;
  const double left = limit - std::min(stretched, limit);
  force.slip_damping = left / std::max(speed, contact_.slip_speed_m_s);
}

}  // namespace scarab::plant
