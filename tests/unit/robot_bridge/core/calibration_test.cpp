#include "services/robot_bridge/core/calibration.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace scarab::bridge {
namespace {

constexpr JointCalibration kTurned{0.2, -1, -1.5, 1.0};  // mounted the other way round, 0.2 rad off

TEST(Calibration, ServoStandsOffTheJoint) {
  EXPECT_DOUBLE_EQ(to_servo_rad(kTurned, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(to_servo_rad(kTurned, 0.5), -0.3);
  EXPECT_DOUBLE_EQ(to_servo_rad({0.2, 1, -1.5, 1.0}, 0.5), 0.7);
}

TEST(Calibration, ThereAndBackIsTheSameAngle) {
  for (const int direction : {1, -1}) {
    const JointCalibration c{-0.31, direction, -2.0, 2.0};
    for (double joint_rad = -1.6; joint_rad <= 1.6; joint_rad += 0.1) {
      EXPECT_NEAR(to_joint_rad(c, to_servo_rad(c, joint_rad)), joint_rad, 1e-15);
    }
  }
}

TEST(Calibration, NoGoalLiesBeyondTheServosRange) {
  EXPECT_DOUBLE_EQ(to_servo_rad(kTurned, 10.0), -1.5);
  EXPECT_DOUBLE_EQ(to_servo_rad(kTurned, -10.0), 1.0);
}

TEST(Calibration, AMeasurementIsNotEnded) { EXPECT_DOUBLE_EQ(to_joint_rad(kTurned, -2.0), 2.2); }

TEST(Calibration, SpeedsAndTorquesTurnButHaveNoOffset) {
  EXPECT_DOUBLE_EQ(turned(kTurned, 3.0), -3.0);
  EXPECT_DOUBLE_EQ(turned({0.2, 1, -1.5, 1.0}, 3.0), 3.0);
}

TEST(Calibration, ReachIsWhatTheServosRangeLetsTheJointDo) {
  const JointRange range = reach(kTurned);
  EXPECT_DOUBLE_EQ(range.min_rad, -0.8);
  EXPECT_DOUBLE_EQ(range.max_rad, 1.7);
  EXPECT_DOUBLE_EQ(to_servo_rad(kTurned, range.min_rad), kTurned.max_rad);
  EXPECT_DOUBLE_EQ(to_servo_rad(kTurned, range.max_rad), kTurned.min_rad);
}

TEST(Calibration, ARobotIsCutToWhatItsServosReach) {
  robot::RobotModel robot;
  for (robot::Joint& joint : robot.joints) {
    joint.min_rad = -1.0;
    joint.max_rad = 1.0;
  }
  robot.joints[2].present = false;
  Calibration calibration;
  calibration.joints[0] = kTurned;
  calibration.joints[2] = kTurned;
  const robot::RobotModel cut = within_reach(robot, calibration);
  EXPECT_DOUBLE_EQ(cut.joints[0].min_rad, -0.8);
  EXPECT_DOUBLE_EQ(cut.joints[0].max_rad, 1.0);
  EXPECT_DOUBLE_EQ(cut.joints[1].min_rad, -1.0) << "no servo is known to limit it";
  EXPECT_DOUBLE_EQ(cut.joints[2].min_rad, -1.0) << "the robot lacks it";
}

TEST(Calibration, OfARobotIsThatOfItsJointsAndOfAllOfThem) {
  robot::RobotModel robot;
  robot.name = "one leg";
  for (robot::Joint& joint : robot.joints) joint.present = false;
  robot.joints[4].present = true;
  Calibration calibration;
  calibration.joints[2] = calibration.joints[4] = kTurned;
  const Calibration own = of_robot(calibration, robot);
  EXPECT_TRUE(own.joints[4]);
  EXPECT_FALSE(own.joints[2]) << "the robot lacks it";
  calibration.joints[4].reset();
  try {
    static_cast<void>(of_robot(calibration, robot));
    FAIL() << "a joint without a calibration";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "joint TR1 of one leg has no calibration");
  }
}

TEST(Calibration, OfNoServoUnlessSaid) {
  for (const auto& joint : Calibration{}.joints) EXPECT_FALSE(joint.has_value());
}

}  // namespace
}  // namespace scarab::bridge
