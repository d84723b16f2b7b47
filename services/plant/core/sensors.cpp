#include "services/plant/core/sensors.hpp"

#include <algorithm>
#include <cmath>

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

std::array<double, 3> to_array(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

Observation measure(const Morphology& morphology, const MotionState& state, const Stepper& stepper,
                    double gravity_m_s2) {
  Observation out;
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (!morphology.joints[j].present) continue;
    out.position_rad[j] = state.joint_rad[j];
    out.velocity_rad_s[j] = state.speed(static_cast<Index>(kJointSpeed + j));
    out.torque_nm[j] = stepper.servo_torque_nm()[j];
  }
  for (const ResolvedContact& contact : stepper.contacts()) {
    if (contact.contact.b.solid == Solid::kFoot) {
      out.foot_force_n[contact.contact.b.leg] += std::max(0.0, contact.normal_n);
    }
    if (contact.contact.a.solid == Solid::kFoot) {
      out.foot_force_n[contact.contact.a.leg] += std::max(0.0, contact.normal_n);
    }
  }
  const Matrix3d R_world_body = state.trunk_orientation.toRotationMatrix();
  const Vector3d up_body = R_world_body.transpose() * Vector3d::UnitZ();
  out.roll_rad = std::atan2(up_body.y(), up_body.z());
  out.pitch_rad = std::atan2(-up_body.x(), std::hypot(up_body.y(), up_body.z()));
  const Vector3d spin = state.speed.segment<3>(static_cast<Index>(kTrunkSpeed));
  const Vector3d acceleration =
      stepper.acceleration().segment<3>(static_cast<Index>(kTrunkSpeed + 3));
  out.angular_velocity_rad_s = to_array(R_world_body.transpose() * spin);
  out.acceleration_m_s2 =
      to_array(R_world_body.transpose() * (acceleration + gravity_m_s2 * Vector3d::UnitZ()));
  return out;
}

}  // namespace scarab::plant
