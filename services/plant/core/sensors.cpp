#include "services/plant/core/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "common/random/random.hpp"

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

std::array<double, 3> to_array(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Every element of a sensor has a stream of its own: the sensor's plus the element's number.
template <std::size_t N>
void disturb(std::array<double, N>& values, double deviation, std::string_view sensor,
             std::uint64_t seed, std::uint64_t sample) {
  if (deviation <= 0) return;
  for (std::size_t i = 0; i < N; ++i) {
    values[i] += deviation * random::gaussian(seed, random::stream(sensor) + i, sample);
  }
}

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

void add_noise(const SensorNoiseConfig& noise, const Morphology& morphology, std::uint64_t seed,
               std::uint64_t sample, Observation& observation) {
  disturb(observation.position_rad, noise.position_rad, "joint_position", seed, sample);
  disturb(observation.velocity_rad_s, noise.velocity_rad_s, "joint_velocity", seed, sample);
  disturb(observation.torque_nm, noise.torque_nm, "joint_torque", seed, sample);
  disturb(observation.foot_force_n, noise.foot_force_n, "foot_force", seed, sample);
  disturb(observation.angular_velocity_rad_s, noise.angular_velocity_rad_s, "gyro", seed, sample);
  disturb(observation.acceleration_m_s2, noise.acceleration_m_s2, "accelerometer", seed, sample);
  std::array<double, 2> inclination = {observation.roll_rad, observation.pitch_rad};
  disturb(inclination, noise.inclination_rad, "inclination", seed, sample);
  observation.roll_rad = inclination[0];
  observation.pitch_rad = inclination[1];
  for (double& force : observation.foot_force_n) force = std::max(0.0, force);
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    if (morphology.joints[j].present) continue;
    observation.position_rad[j] = observation.velocity_rad_s[j] = observation.torque_nm[j] = 0;
  }
}

}  // namespace scarab::plant
