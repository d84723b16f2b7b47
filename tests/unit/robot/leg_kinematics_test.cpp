#include "common/robot/leg_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/config/robot_file.hpp"

namespace scarab::robot {
namespace {

constexpr double kExact = 1e-12;

RobotModel beetle() { return config::load_robot(SCARAB_SOURCE_DIR "/config/robot/beetle.yaml"); }

/// The beetle with its legs straight out sideways from the mounts.
RobotModel untilted() {
  RobotModel model = beetle();
  for (LegRow& row : model.rows) {
    row.mount_yaw_rad = row.mount_elevation_rad = row.mount_rotation_rad = 0;
  }
  return model;
}

std::vector<LegAngles> poses() {
  return {{0, 0, 0}, {0.4, 0, 0}, {0, -0.5, 0.9}, {0.3, 0.2, 1.4}, {-0.6, -1.0, 0.1}};
}

TEST(FootPosition, LeftAndRightMirrorEachOther) {
  const RobotModel model = beetle();
  for (std::size_t row = 0; row < 3; ++row) {
    for (const LegAngles& angles : poses()) {
      const auto left = foot_position_m(model, static_cast<Leg>(row), angles);
      const auto right = foot_position_m(model, static_cast<Leg>(row + 3), angles);
      EXPECT_NEAR(left.x(), right.x(), kExact);
      EXPECT_NEAR(left.y(), -right.y(), kExact);
      EXPECT_NEAR(left.z(), right.z(), kExact);
    }
  }
}

TEST(FootPosition, OfAStraightLegIsItsLengthOutFromTheMount) {
  const RobotModel model = untilted();
  const auto foot = foot_position_m(model, Leg::kL1, {});
  EXPECT_NEAR(foot.x(), 0.025, kExact);
  EXPECT_NEAR(foot.y(), 0.035 + 0.045 + 0.035 + 0.06 + 0.115, kExact);
  EXPECT_NEAR(foot.z(), 0.0325, kExact);
}

TEST(FootPosition, SignsAreForwardUpAndFlexionForEveryLeg) {
  const RobotModel model = untilted();
  for (const Leg leg : kLegs) {
    const auto rest = foot_position_m(model, leg, {});
    EXPECT_GT(foot_position_m(model, leg, {0.2, 0, 0}).x(), rest.x()) << "T + is forward";
    EXPECT_GT(foot_position_m(model, leg, {0, 0.2, 0}).z(), rest.z()) << "C + is up";
    const auto flexed = foot_position_m(model, leg, {0, 0, 0.2});
    EXPECT_LT(flexed.z(), rest.z()) << "F + is down";
    EXPECT_LT(std::abs(flexed.y()), std::abs(rest.y())) << "F + is inwards";
  }
}

TEST(FootPosition, MountSignsAreForwardUpAndBackward) {
  for (const Leg leg : kLegs) {
    const auto rest = foot_position_m(untilted(), leg, {0, 0, 1.4});
    RobotModel yawed = untilted(), raised = untilted(), rotated = untilted();
    yawed.rows[row(leg)].mount_yaw_rad = 0.2;
    raised.rows[row(leg)].mount_elevation_rad = 0.2;
    rotated.rows[row(leg)].mount_rotation_rad = 0.2;
    EXPECT_GT(foot_position_m(yawed, leg, {0, 0, 1.4}).x(), rest.x());
    EXPECT_GT(foot_position_m(raised, leg, {0, 0, 1.4}).z(), rest.z());
    EXPECT_LT(foot_position_m(rotated, leg, {0, 0, 1.4}).x(), rest.x()) << "down points back";
  }
}

TEST(FootPosition, StandsAtTheMeasuredHeight) {
  // facts of a prototype: with T 0, C 0, F 1.4 rad the trunk's centre stands 94 mm above the
  // ground, give or take the sag of its servos.
  const RobotModel model = untilted();
  const double height_m = -foot_position_m(model, Leg::kR1, {0, 0, 1.4}).z() + 0.015;
  EXPECT_NEAR(height_m, 0.094, 0.003);
}

TEST(LegPoints, AreASegmentApart) {
  const RobotModel model = beetle();
  for (const Leg leg : kLegs) {
    const LegRow& of = model.rows[row(leg)];
    const std::array<double, 4> lengths_m = {of.shoulder.length_m, of.coxa.length_m,
                                             of.femur.length_m, of.tibia.length_m};
    for (const LegAngles& angles : poses()) {
      const auto points = leg_points_m(model, leg, angles);
      for (std::size_t i = 0; i < lengths_m.size(); ++i) {
        EXPECT_NEAR((points[i + 1] - points[i]).norm(), lengths_m[i], kExact);
      }
    }
  }
}

TEST(LegAngles, ComeFromTheLegsSlotsAndAreZeroForAbsentJoints) {
  RobotModel model = beetle();
  JointVector joints{};
  for (std::size_t slot = 0; slot < kJointCount; ++slot) joints[slot] = static_cast<double>(slot);
  const LegAngles angles = leg_angles(model, Leg::kR1, joints);
  EXPECT_EQ(angles.t_rad, 4);   // TR1
  EXPECT_EQ(angles.c_rad, 10);  // CR1
  EXPECT_EQ(angles.f_rad, 16);  // FR1
  model.joints[10].present = false;
  EXPECT_EQ(leg_angles(model, Leg::kR1, joints).c_rad, 0);
}

}  // namespace
}  // namespace scarab::robot
