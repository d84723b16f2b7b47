// The cylinder alone on the ground and against the wall, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using testing::Rig;

constexpr double kG = 9.81;
constexpr double kRadius = 0.09;
/// It touches the ground in the middle of its penetration.
constexpr double kRollingRadius = kRadius - 0.5 * 2 * kG / 4e4;

class ObjectMotion : public ::testing::Test {
 protected:
  /// The cylinder settled on the ground, the robot far away in the air, where it falls unseen.
  Rig alone(double rolling_resistance_m, const Wall& wall = {}) {
    PlantConfig config = testing::default_config();
    config.contact.object_rolling_resistance_m = rolling_resistance_m;
    Rig rig(testing::beetle(), config, wall);
    rig.state.trunk_position += Vector3d(0, 100, 1000);
    rig.run(1, 0.002);
    return rig;
  }

  static void set_velocity(Rig& rig, const Vector3d& linear, const Vector3d& angular) {
    rig.state.speed.segment<3>(static_cast<Index>(kObjectSpeed)) = angular;
    rig.state.speed.segment<3>(static_cast<Index>(kObjectSpeed + 3)) = linear;
  }

  static Vector3d velocity(const Rig& rig) {
    return rig.state.speed.segment<3>(static_cast<Index>(kObjectSpeed + 3));
  }
  static double spin(const Rig& rig) {
    return rig.state.speed(static_cast<Index>(kObjectSpeed + 1));
  }
};

TEST_F(ObjectMotion, RestsOnItsWeight) {
  const Rig rig = alone(0.005);
  double normal = 0;
  for (const ResolvedContact& contact : rig.stepper.contacts()) normal += contact.normal_n;
  EXPECT_NEAR(normal, 2 * kG, 1e-3 * 2 * kG);
  EXPECT_LT(velocity(rig).norm(), 1e-6);
}

TEST_F(ObjectMotion, RollsWithoutSlip) {
  Rig rig = alone(0);
  const double speed = 0.45;
  set_velocity(rig, Vector3d(-speed, 0, 0), Vector3d(0, -speed / kRadius, 0));
  const double start = rig.state.object_position.x();
  rig.run(2, 0.002);
  EXPECT_NEAR(start - rig.state.object_position.x(), 0.9, 0.9e-3);
  EXPECT_NEAR(spin(rig) * kRollingRadius, velocity(rig).x(), 1e-3 * speed);
}

TEST_F(ObjectMotion, SlidingTurnsIntoRollingAtTwoThirdsOfTheSpeed) {
  Rig rig = alone(0);
  set_velocity(rig, Vector3d(1.5, 0, 0), Vector3d::Zero());
  rig.run(1, 0.002);
  EXPECT_NEAR(velocity(rig).x(), 1.0, 0.01);  // of a solid cylinder, whatever the friction
  EXPECT_NEAR(spin(rig) * kRollingRadius, velocity(rig).x(), 1e-3);
}

TEST_F(ObjectMotion, RollingResistanceStopsItAfterTheExpectedDistance) {
  const double lever = 0.005, speed = 0.6;
  Rig rig = alone(lever);
  set_velocity(rig, Vector3d(-speed, 0, 0), Vector3d(0, -speed / kRadius, 0));
  const double start = rig.state.object_position.x();
  rig.run(3, 0.002);
  // Torque lever m g against m r^2 (1 + 1/2): deceleration (2/3) g lever / r.
  const double distance = speed * speed / (2 * (2.0 / 3) * kG * lever / kRadius);
  EXPECT_NEAR(start - rig.state.object_position.x(), distance, 0.01 * distance);
  EXPECT_LT(std::abs(velocity(rig).x()), 2e-3);
}

TEST_F(ObjectMotion, SlidesTheCoulombDistance) {
  Rig rig = alone(0);
  const double speed = 2;
  set_velocity(rig, Vector3d(0, speed, 0), Vector3d::Zero());  // along its axis: it cannot roll
  const double start = rig.state.object_position.y();
  rig.run(1, 0.002);
  const double distance = speed * speed / (2 * rig.config.friction.object_ground * kG);
  EXPECT_NEAR(rig.state.object_position.y() - start, distance, 0.01 * distance);
  EXPECT_LT(velocity(rig).norm(), 2e-3);
}

TEST_F(ObjectMotion, DoesNotPassTheWall) {
  for (const double dt : {0.001, 0.004}) {
    for (const double speed : {0.5, 3.0}) {
      Rig rig = alone(0, {-1, 0.0005, 0.11});
      set_velocity(rig, Vector3d(-speed, 0, 0), Vector3d(0, -speed / kRadius, 0));
      double nearest = 1;
      for (int i = 0; i < std::lround(1.5 / dt); ++i) {
        rig.step(dt);
        nearest = std::min(nearest, rig.state.object_position.x() + 1);
      }
      EXPECT_LT(nearest, kRadius + 0.001) << "it must have reached the wall";
      EXPECT_GT(nearest, 0.5 * kRadius) << "dt " << dt << ", speed " << speed;
    }
  }
}

TEST_F(ObjectMotion, RestsAslantOnTheWallsEdgeInsteadOfFallingThroughIt) {
  // Axis at 45 degrees over the wall: neither end is near it, the edge carries the middle.
  Rig rig = alone(0.005, {-1, 0.0005, 0.11});
  rig.state.object_position = Vector3d(-1, 0, 0.11 + kRadius);
  rig.state.object_orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.785, Vector3d::UnitZ()));
  set_velocity(rig, Vector3d::Zero(), Vector3d::Zero());
  rig.run(0.2, 0.002);
  EXPECT_GT(rig.state.object_position.z(), 0.11 + kRadius - 0.01);
}

}  // namespace
}  // namespace scarab::plant
