// Motion without contact: free fall, conservation in a passive swing.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using Eigen::Vector3d;
using testing::Rig;

/// Velocity of a body's centre of mass.
Vector3d centre_velocity(const BodyMotion& body, const BodyMass& mass) {
  return body.velocity + body.angular_velocity.cross(body.R_world_body * mass.centre_m);
}

/// Of robot and object; needs no mass matrix, so it checks that one too.
double kinetic_energy(const Rig& rig) {
  const Kinematics kinematics = testing::kinematics_of(rig.morphology, rig.state);
  double energy = 0;
  for (std::size_t i = 0; i < kBodyCount; ++i) {
    const BodyMotion& body = kinematics.body[i];
    const BodyMass& mass = rig.morphology.mass[i];
    const Vector3d spin = body.R_world_body.transpose() * body.angular_velocity;
    energy += 0.5 * mass.mass_kg * centre_velocity(body, mass).squaredNorm() +
              0.5 * spin.dot(mass.inertia_kg_m2 * spin);
  }
  return energy;
}

Vector3d robot_momentum(const Rig& rig) {
  const Kinematics kinematics = testing::kinematics_of(rig.morphology, rig.state);
  Vector3d momentum = Vector3d::Zero();
  for (std::size_t i = 0; i < kObjectBody; ++i) {
    const BodyMass& mass = rig.morphology.mass[i];
    momentum += mass.mass_kg * centre_velocity(kinematics.body[i], mass);
  }
  return momentum;
}

Vector3d robot_centre(const Rig& rig) {
  const Kinematics kinematics = testing::kinematics_of(rig.morphology, rig.state);
  Vector3d moment = Vector3d::Zero();
  for (std::size_t i = 0; i < kObjectBody; ++i) {
    moment += rig.morphology.mass[i].mass_kg *
              kinematics.body[i].to_world(rig.morphology.mass[i].centre_m);
  }
  return moment / testing::robot_mass(rig.morphology);
}

/// A robot whose joints turn freely, without servos, rotor inertia or stops.
robot::RobotModel limp() {
  robot::RobotModel robot = testing::beetle();
  for (robot::Joint& joint : robot.joints) {
    joint.kp_nm_rad = joint.kd_nm_s_rad = joint.armature_kg_m2 = 0;
    joint.min_rad = -1e3;
    joint.max_rad = 1e3;
  }
  return robot;
}

TEST(FreeFall, RobotAndObjectFallAlike) {
  Rig rig(testing::beetle(), testing::default_config());
  rig.lift(10);
  const Vector3d centre = robot_centre(rig);
  const double object = rig.state.object_position.z();
  const double dt = 0.002, duration = 1;
  rig.run(duration, dt);
  const double fallen =
      0.5 * 9.81 * duration * (duration + dt);  // of the method: n (n + 1) / 2 steps
  EXPECT_NEAR(object - rig.state.object_position.z(), fallen, 1e-9);
  EXPECT_NEAR((centre - robot_centre(rig)).z(), fallen, 1e-6);
  EXPECT_NEAR((centre - robot_centre(rig)).head<2>().norm(), 0, 1e-6);
  EXPECT_TRUE(rig.stepper.contacts().empty());
}

/// Share of its energy that a limp robot, tumbling without weight, gains or loses in half a second.
double energy_drift(double dt) {
  PlantConfig config = testing::default_config();
  config.gravity_m_s2 = 0;
  Rig rig(limp(), config);
  rig.lift(20);
  rig.state.speed.segment<19>(static_cast<Eigen::Index>(kJointSpeed)).setConstant(1.5);
  rig.state.speed.segment<3>(0) = Vector3d(0.3, -0.5, 0.4);
  const double start = kinetic_energy(rig);
  for (long i = 0; i < std::lround(0.5 / dt); ++i) {
    rig.step(dt);
    EXPECT_TRUE(rig.stepper.contacts().empty()) << "legs that touch lose energy";
  }
  return std::abs(kinetic_energy(rig) - start) / start;
}

TEST(PassiveSwing, KeepsItsEnergy) {
  const double coarse = energy_drift(0.0004);
  const double fine = energy_drift(0.0001);
  EXPECT_LT(fine, 0.01);
  EXPECT_NEAR(coarse / fine, 4, 1);  // a method of first order
}

TEST(PassiveSwing, KeepsItsMomentum) {
  PlantConfig config = testing::default_config();
  config.gravity_m_s2 = 0;
  Rig rig(limp(), config);
  rig.lift(20);
  rig.state.speed.segment<19>(static_cast<Eigen::Index>(kJointSpeed)).setConstant(1.5);
  const Vector3d drift = robot_momentum(rig);
  const Vector3d centre = robot_centre(rig);
  rig.run(0.5, 0.0002);
  EXPECT_NEAR((robot_momentum(rig) - drift).norm(), 0, 1e-3 * drift.norm());
  const Vector3d expected = centre + 0.5 * drift / testing::robot_mass(rig.morphology);
  EXPECT_NEAR((robot_centre(rig) - expected).norm(), 0, 1e-4);
}

}  // namespace
}  // namespace scarab::plant
