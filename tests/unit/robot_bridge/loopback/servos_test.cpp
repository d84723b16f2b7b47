#include "services/robot_bridge/drivers/loopback/servos.hpp"

#include <gtest/gtest.h>

namespace scarab::bridge::loopback {
namespace {

class LoopbackServos : public testing::Test {
 protected:
  static robot::RobotModel model() {
    robot::RobotModel model;
    for (robot::Joint& joint : model.joints) joint.velocity_max_rad_s = 2;
    return model;
  }

  static robot::JointVector goals(double rad) {
    robot::JointVector goals{};
    goals.fill(rad);
    return goals;
  }

  Servos servos_{model(), {}};
};

TEST_F(LoopbackServos, StandWithoutTorque) {
  servos_.set_goals(goals(1));
  servos_.advance(1);
  EXPECT_EQ(servos_.angle_rad(), goals(0));
}

TEST_F(LoopbackServos, TurnToTheirGoalAtTheirSpeedLimit) {
  servos_.set_torque(true);
  servos_.set_goals(goals(-1));
  servos_.advance(0.1);
  EXPECT_DOUBLE_EQ(servos_.angle_rad()[3], -0.2);
  EXPECT_DOUBLE_EQ(servos_.velocity_rad_s()[3], -2);
  servos_.advance(10);
  EXPECT_DOUBLE_EQ(servos_.angle_rad()[3], -1);
  servos_.advance(1);
  EXPECT_EQ(servos_.velocity_rad_s(), goals(0));
}

TEST_F(LoopbackServos, StopWhereTheyAre) {
  servos_.set_torque(true);
  servos_.set_goals(goals(1));
  servos_.advance(0.1);
  servos_.stop();
  servos_.advance(1);
  EXPECT_DOUBLE_EQ(servos_.angle_rad()[0], 0.2);
}

TEST_F(LoopbackServos, AStuckOneStays) {
  servos_.set_torque(true);
  servos_.set_stuck(4, true);
  servos_.set_goals(goals(1));
  servos_.advance(1);
  EXPECT_EQ(servos_.angle_rad()[4], 0);
  EXPECT_EQ(servos_.angle_rad()[5], 1);
}

}  // namespace
}  // namespace scarab::bridge::loopback
