#include "services/robot_bridge/calibrate/measures.hpp"

#include <gtest/gtest.h>

#include "services/robot_bridge/calibrate/own_scales.hpp"

namespace scarab::bridge::calibrate {
namespace {

TEST(CalibrateMeasures, TheOffsetPutsTheJointWhereItStood) {
  for (const int direction : {-1, 1}) {
    for (const double joint_rad : {-0.7, 0.0, 0.4}) {
      const JointCalibration c{offset_of(0.55, direction, joint_rad), direction, -2, 2};
      EXPECT_NEAR(to_joint_rad(c, 0.55), joint_rad, 1e-12);
    }
  }
}

TEST(CalibrateMeasures, TheDirectionNeedsAMove) {
  EXPECT_EQ(direction_of(0.2, 0.35), 1);
  EXPECT_EQ(direction_of(0.2, -0.35), -1);
  EXPECT_EQ(direction_of(0.2, 0.25), std::nullopt);
}

TEST(CalibrateMeasures, ATravelIsWhatWasSeen) {
  Travel travel(0.1);
  EXPECT_FALSE(travel.is_walked_through());
  for (const double angle : {0.2, -0.3, 0.15}) travel.see(angle);
  EXPECT_EQ(travel.min_rad(), -0.3);
  EXPECT_EQ(travel.max_rad(), 0.2);
  EXPECT_TRUE(travel.is_walked_through());
}

TEST(CalibrateMeasures, TheRangeHoldsTheOffset) {
  // A knee: its 0 is its end, and the reading there was a little beyond the travel seen later.
  Travel travel(0.0);
  travel.see(1.5);
  const JointCalibration c = measured(-0.004, 0, 1, travel);
  EXPECT_EQ(c.offset_rad, -0.004);
  EXPECT_EQ(c.min_rad, -0.004);
  EXPECT_EQ(c.max_rad, 1.5);
}

/// Whatever a servo's true mounting and travel, two looks at it find them.
TEST(CalibrateMeasures, TwoLooksFindTheTrueServo) {
  const JointCalibration nominal{0, 1, -0.8, 0.8};
  for (const double stretch : {0.5, 1.0, 1.6}) {
    for (const int direction : {-1, 1}) {
      const JointCalibration truth{0.12, direction, -0.8 * stretch, 0.8 * stretch};
      const auto standing = [&](double joint_rad) {
        return Standing{to_servo_rad(truth, joint_rad) / stretch, joint_rad};
      };
      const auto found = driven(nominal, standing(-0.1), standing(0.2));
      ASSERT_TRUE(found.has_value());
      EXPECT_NEAR(found->offset_rad, truth.offset_rad, 1e-12);
      EXPECT_EQ(found->direction, direction);
      EXPECT_NEAR(found->min_rad, truth.min_rad, 1e-12);
      EXPECT_NEAR(found->max_rad, truth.max_rad, 1e-12);
    }
  }
}

TEST(CalibrateMeasures, TwoLooksAtOnePlaceFindNothing) {
  EXPECT_FALSE(driven({0, 1, -1, 1}, {0.3, 0}, {0.32, 0.5}).has_value());
  EXPECT_FALSE(driven({0, 1, -1, 1}, {0.3, 0.2}, {0.9, 0.25}).has_value());
}

TEST(CalibrateMeasures, TheSecondLookIsInsideTheRange) {
  robot::Joint knee;
  knee.min_rad = 0;
  knee.max_rad = 1.57;
  EXPECT_NEAR(second_look_rad(knee, 0), 0.5, 1e-12);
  EXPECT_NEAR(second_look_rad(knee, 1.2), 0.7, 1e-12);
  robot::Joint stiff;
  stiff.min_rad = -0.2;
  stiff.max_rad = 0.3;
  EXPECT_NEAR(second_look_rad(stiff, 0), 0.3, 1e-12);
}

TEST(CalibrateMeasures, CoversWhatTheServoReaches) {
  robot::Joint joint;
  joint.min_rad = -1;
  joint.max_rad = 0.5;
  EXPECT_TRUE(covers({0.2, -1, -0.3, 1.2}, joint));
  EXPECT_FALSE(covers({0.2, 1, -0.3, 1.2}, joint));
}

TEST(CalibrateMeasures, OwnScalesAreTheServosAngles) {
  robot::RobotModel robot;
  robot.joints[3].present = false;
  const Calibration scales = own_scales(robot);
  EXPECT_FALSE(scales.joints[3].has_value());
  EXPECT_EQ(to_joint_rad(*scales.joints[4], 1.25), 1.25);
  Calibration known;
  known.joints[4] = JointCalibration{0.3, -1, -0.9, 0.7};
  robot.joints[5].min_rad = -0.5;
  robot.joints[5].max_rad = 1.5;
  const Calibration fractions = own_scales(robot, known);
  EXPECT_EQ(fractions.joints[4]->offset_rad, 0);
  EXPECT_EQ(fractions.joints[4]->direction, 1);
  EXPECT_EQ(fractions.joints[4]->min_rad, -0.9);
  EXPECT_EQ(fractions.joints[5]->max_rad, 1);
}

}  // namespace
}  // namespace scarab::bridge::calibrate
