#include "services/premotor/core/motor_map.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/unit/premotor/f2_config.hpp"

namespace scarab::premotor {
namespace {

using robot::Leg;
using robot::LegJoint;

/// Numbers that cannot be mistaken for one another, and ranges that clip none of them.
MotorConfig plain_config() {
  const MotorRowConfig row = {0.1, 2, 0.2, 3, 0, 0, 0.3, 0};
  MotorConfig config{row, row, row};
  config.hind.c_floor = -0.1;
  config.hind.c_i4_gain_rad = 0.5;
  config.hind.f_i3_gain_rad = -0.7;
  return config;
}

robot::RobotModel wide_robot() {
  robot::RobotModel robot;
  for (robot::Joint& joint : robot.joints) {
    joint.min_rad = -10;
    joint.max_rad = 10;
  }
  return robot;
}

double at(const robot::JointVector& target, Leg leg, LegJoint joint) {
  return target[joint_slot(leg, joint)];
}

TEST(MotorMap, AddsGainTimesOutputToTheOffset) {
  NetworkState state;
  state.motor[joint_slot(Leg::kR1, LegJoint::kThoracoCoxal)] = -0.25;
  state.motor[joint_slot(Leg::kR1, LegJoint::kCoxaTrochanteral)] = 0.5;
  const auto target = MotorMap(plain_config(), wide_robot()).targets(state, {}, 0.05);
  EXPECT_DOUBLE_EQ(at(target, Leg::kR1, LegJoint::kThoracoCoxal), 0.1 - 0.5);
  EXPECT_DOUBLE_EQ(at(target, Leg::kR1, LegJoint::kCoxaTrochanteral), 0.2 + 1.5);
  EXPECT_DOUBLE_EQ(at(target, Leg::kR1, LegJoint::kFemurTibia), 0.3);
  EXPECT_DOUBLE_EQ(at(target, Leg::kL1, LegJoint::kThoracoCoxal), 0.1) << "other legs stay";
  EXPECT_DOUBLE_EQ(target[robot::kBackboneSlot], 0.05);
}

TEST(MotorMap, ClipsTheCSignalSoThatStanceStaysOnTheGround) {
  NetworkState state;
  state.motor.fill(-0.5);
  const auto target = MotorMap(plain_config(), wide_robot()).targets(state, {}, 0);
  EXPECT_DOUBLE_EQ(at(target, Leg::kL0, LegJoint::kCoxaTrochanteral), 0.2) << "floor 0";
  EXPECT_DOUBLE_EQ(at(target, Leg::kL2, LegJoint::kCoxaTrochanteral), 0.2 - 0.3) << "floor -0.1";
}

TEST(MotorMap, ShiftsTheHindOffsetsByI3AndI4Alone) {
  NetworkState state;
  state.input = {0, 0, 1, -0.3};
  const auto target = MotorMap(plain_config(), wide_robot()).targets(state, {}, 0);
  for (const Leg leg : robot::kLegs) {
    const bool hind = robot::row(leg) == 2;
    EXPECT_DOUBLE_EQ(at(target, leg, LegJoint::kCoxaTrochanteral), hind ? 0.2 - 0.15 : 0.2);
    EXPECT_DOUBLE_EQ(at(target, leg, LegJoint::kFemurTibia), hind ? 0.3 - 0.7 : 0.3);
  }
}

TEST(MotorMap, PutsTheHindLegsInTheGivenPose) {
  NetworkState state;
  state.motor.fill(0.4);
  state.input = {0, 1, 1, 1};
  const std::array<double, 3> pose = {-0.6, 0.2, 0.8};
  const MotorMap map(plain_config(), wide_robot());
  const auto free = map.targets(state, {}, 0);
  const auto held = map.targets(state, pose, 0);
  for (const Leg leg : robot::kLegs) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto joint = static_cast<LegJoint>(j);
      EXPECT_DOUBLE_EQ(at(held, leg, joint), robot::row(leg) == 2 ? pose[j] : at(free, leg, joint));
    }
  }
}

TEST(MotorMap, ClipsEveryTargetToItsJointRange) {
  const robot::RobotModel robot = beetle();
  const MotorMap map(f2_config().motor, robot);
  for (const double extreme : {-100.0, 100.0}) {
    NetworkState state;
    state.motor.fill(extreme);
    state.input.fill(extreme);
    const std::array<double, 3> pose = {extreme, extreme, extreme};
    for (const auto& target :
         {map.targets(state, {}, extreme), map.targets(state, pose, extreme)}) {
      for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
        EXPECT_GE(target[slot], robot.joints[slot].min_rad) << robot::kJointNames[slot];
        EXPECT_LE(target[slot], robot.joints[slot].max_rad) << robot::kJointNames[slot];
      }
    }
  }
}

TEST(MotorMap, LeavesAbsentJointsAtZero) {
  robot::RobotModel robot = wide_robot();
  robot.joints[robot::kBackboneSlot] = {};
  robot.joints[robot::kBackboneSlot].present = false;
  EXPECT_EQ(MotorMap(plain_config(), robot).targets({}, {}, 0.3)[robot::kBackboneSlot], 0);
}

TEST(MotorMap, RefusesValuesThatAreNotFiniteAndEmptyRanges) {
  MotorConfig config = plain_config();
  config.middle.c_gain_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(MotorMap(config, wide_robot()), std::invalid_argument);
  robot::RobotModel robot = wide_robot();
  robot.joints[3].min_rad = 11;
  EXPECT_THROW(MotorMap(plain_config(), robot), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::premotor
