#include "common/safety/target_limiter.hpp"

#include <gtest/gtest.h>

#include "common/safety/target_window.hpp"
#include "tests/unit/safety/small_robot.hpp"

namespace scarab::safety {
namespace {

TEST(WithinWindow, IsThePreviousTargetAndWhatTheSpeedAllows) {
  EXPECT_DOUBLE_EQ(within_window(1.0, 9.0, 2.0, 0.1), 1.2);
  EXPECT_DOUBLE_EQ(within_window(1.0, -9.0, 2.0, 0.1), 0.8);
  EXPECT_DOUBLE_EQ(within_window(1.0, 1.1, 2.0, 0.1), 1.1);
}

TEST(WithinTorque, IsTheMeasuredAngleAndWhatTheServoMayPull) {
  robot::Joint joint;
  joint.kp_nm_rad = 10;
  joint.torque_max_nm = 4;
  EXPECT_DOUBLE_EQ(within_torque(joint, 0.1, 9.0), 0.5);
  EXPECT_DOUBLE_EQ(within_torque(joint, 0.1, -9.0), -0.3);
  EXPECT_DOUBLE_EQ(within_torque(joint, 0.1, 0.2), 0.2);
  joint.kp_nm_rad = 0;
  EXPECT_DOUBLE_EQ(within_torque(joint, 0.1, 9.0), 9.0);
}

TEST(TargetLimiter, CountsEachKindOfClampForEachJoint) {
  TargetLimiter limiter(small_robot(), kTickPeriod, 1.0);
  limiter.start_from(all(0));
  GateCounters counters;
  limiter.advance(all(0.1), std::nullopt, counters);
  EXPECT_EQ(counters.of(Clamp::kRange) + counters.of(Clamp::kWindow), 0U);
  limiter.advance(all(0.6), std::nullopt, counters);
  EXPECT_EQ(counters.of(Clamp::kRange), 18U);
  EXPECT_EQ(counters.of(Clamp::kWindow), 18U);
  EXPECT_EQ(counters.of(Clamp::kTorque), 0U);
  limiter.start_from(all(0));
  limiter.advance(all(-0.1), all(0.35), counters);  // would be 4.5 N m
  EXPECT_EQ(counters.of(Clamp::kTorque), 18U);
  EXPECT_NEAR(limiter.target_rad()[0], -0.05, 1e-12);
}

TEST(TargetLimiter, LeadsARobotThatStandsOutOfRangeBackWithoutAJump) {
  TargetLimiter limiter(small_robot(), kTickPeriod, 1.0);
  limiter.start_from(all(1.0));
  GateCounters counters;
  limiter.advance(all(0.4), std::nullopt, counters);
  EXPECT_NEAR(limiter.target_rad()[0], 1.0 - kWindow, 1e-12);
  for (int i = 0; i < 5; ++i) limiter.advance(all(0.4), std::nullopt, counters);
  EXPECT_NEAR(limiter.target_rad()[0], 0.4, 1e-12);
}

}  // namespace
}  // namespace scarab::safety
