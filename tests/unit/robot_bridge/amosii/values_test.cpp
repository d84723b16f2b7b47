#include "services/robot_bridge/drivers/amosii/protocol/values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/robot_bridge/drivers/amosii/protocol/slots.hpp"

namespace scarab::bridge::amosii {
namespace {

bool is_coxa(std::size_t joint) { return 6 <= joint && joint < 12; }

TEST(AmosiiValues, CommandsBeyondOneAreItsEnds) {
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    EXPECT_EQ(motor_byte(joint, -7), kMotorSlots[joint].low) << joint;
    EXPECT_EQ(motor_byte(joint, 7), kMotorSlots[joint].high) << joint;
  }
}

TEST(AmosiiValues, CommandsComeBackWithinHalfAByte) {
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    const double step = 2.0 / std::abs(kMotorSlots[joint].high - kMotorSlots[joint].low);
    // Below -0.9 the trimmed command of a coxa is at its end.
    for (double m = is_coxa(joint) ? -0.9 : -1.0; m <= 1.0; m += 0.001) {
      EXPECT_NEAR(motor_command(joint, motor_byte(joint, m)), m, step / 2 + 1e-9)
          << robot::kJointNames[joint];
    }
  }
}

TEST(AmosiiValues, EveryByteOfAServoComesBackExactly) {
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    const MotorSlot& servo = kMotorSlots[joint];
    for (int byte = std::min(servo.low, servo.high); byte <= std::max(servo.low, servo.high);
         ++byte) {
      const auto sent = static_cast<std::uint8_t>(byte);
      EXPECT_EQ(motor_byte(joint, motor_command(joint, sent)), sent) << robot::kJointNames[joint];
    }
  }
}

TEST(AmosiiValues, TheEndsOfTheTravelArePlusAndMinusOne) {
  // A hind leg's thoraco-coxal joint: +-40 degrees, the board's sign opposite to the project's.
  const JointCalibration thorax{0, -1, -0.7, 0.7};
  EXPECT_DOUBLE_EQ(motor_command_for(thorax, 0.7), -1);
  EXPECT_DOUBLE_EQ(motor_command_for(thorax, 0), 0);
  EXPECT_DOUBLE_EQ(motor_command_for(thorax, -0.35), 0.5);
  EXPECT_DOUBLE_EQ(motor_command_for(thorax, -2), 1) << "no goal beyond the travel";
  // A femur-tibia joint: 0 to 1.5 rad about a servo whose middle is at 0.75.
  const JointCalibration tibia{-0.75, 1, -0.75, 0.75};
  EXPECT_DOUBLE_EQ(motor_command_for(tibia, 0), -1);
  EXPECT_DOUBLE_EQ(motor_command_for(tibia, 1.5), 1);
  for (const double angle : {-0.6, -0.1, 0.0, 0.2, 0.7}) {
    EXPECT_NEAR(joint_angle_for(thorax, motor_command_for(thorax, angle)), angle, 1e-12);
  }
}

TEST(AmosiiValues, TheTrimTakesAwayTheLowestCommandsOfACoxa) {
  EXPECT_DOUBLE_EQ(effective_command(7, -1), -0.9);
  EXPECT_DOUBLE_EQ(effective_command(7, 0.4), 0.4);
  EXPECT_DOUBLE_EQ(effective_command(7, 1), 1);
  EXPECT_DOUBLE_EQ(effective_command(0, -1), -1);
}

TEST(AmosiiValues, FeetAreScaledAsPublished) {
  // low and high of L0, L1, L2, R0, R1, R2
  const int ends[6][2] = {{40, 100}, {30, 130}, {40, 110}, {15, 90}, {60, 120}, {30, 110}};
  for (std::size_t leg = 0; leg < robot::kLegCount; ++leg) {
    const auto low = static_cast<std::uint8_t>(ends[leg][0]);
    const auto high = static_cast<std::uint8_t>(ends[leg][1]);
    EXPECT_EQ(foot_load(leg, low), 0);
    EXPECT_EQ(foot_load(leg, high), 1);
    EXPECT_EQ(foot_load(leg, 1), 0);
    EXPECT_EQ(foot_load(leg, 255), 1);
    EXPECT_NEAR(foot_load(leg, foot_byte(leg, 0.3)), 0.3, 0.5 / (high - low) + 1e-12);
  }
}

TEST(AmosiiValues, LinearInputsNeverReadZero) {
  const LinearInput current{128, 5.0 / 256 / 0.037};
  EXPECT_EQ(measured(current, 128), 0);
  EXPECT_NEAR(measured(current, 138), 5.28, 0.01);
  EXPECT_EQ(input_byte(current, measured(current, 200)), 200);
  EXPECT_EQ(input_byte(current, -1000), 1);
  EXPECT_EQ(input_byte(current, 1000), 255);
  const LinearInput turned{100, -0.01};
  EXPECT_NEAR(measured(turned, 90), 0.1, 1e-12);
  EXPECT_EQ(input_byte(turned, 0.1), 90);
}

}  // namespace
}  // namespace scarab::bridge::amosii
