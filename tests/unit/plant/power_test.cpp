#include <gtest/gtest.h>

#include <bitset>
#include <cmath>

#include "services/plant/core/scene.hpp"
#include "services/plant/core/simulation.hpp"
#include "tests/unit/plant/rig.hpp"

/// Servos without power.
namespace scarab::plant {
namespace {

using testing::beetle;
using testing::default_config;
using Powered = std::bitset<robot::kJointCount>;

constexpr std::size_t kLeft = joint_slot(robot::Leg::kL1, robot::LegJoint::kCoxaTrochanteral);
constexpr std::size_t kRight = joint_slot(robot::Leg::kR1, robot::LegJoint::kCoxaTrochanteral);

robot::JointVector stance() { return start_targets(default_config().start); }

void run(Simulation& simulation, const robot::JointVector& targets, int ticks) {
  for (int tick = 0; tick < ticks; ++tick) simulation.advance(targets, nullptr);
}

TEST(Power, OfEveryServoIsTheSameAsNeverHavingAskedForIt) {
  Simulation asked(beetle(), default_config(), {});
  Simulation plain(beetle(), default_config(), {});
  asked.power(Powered().set());
  robot::JointVector targets = stance();
  targets[kLeft] += 0.3;
  run(asked, targets, 5);
  run(plain, targets, 5);
  EXPECT_EQ(asked.observe().position_rad, plain.observe().position_rad);
  EXPECT_EQ(asked.observe().torque_nm, plain.observe().torque_nm);
}

TEST(Power, TakenFromAllLetsTheRobotSinkToTheGround) {
  Simulation simulation(beetle(), default_config(), {});
  const double stood_m = simulation.truth().trunk.position_m[2];
  simulation.power({});
  run(simulation, stance(), 30);
  const WorldTruth truth = simulation.truth();
  EXPECT_LT(truth.trunk.position_m[2], stood_m - 0.02);
  EXPECT_GT(truth.trunk.position_m[2], 0.03) << "it lies on the ground, not in it";
  for (const double speed : truth.trunk_twist.linear_m_s) EXPECT_LT(std::abs(speed), 0.01);
  const robot::RobotModel robot = beetle();
  const Observation seen = simulation.observe();
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    EXPECT_EQ(seen.torque_nm[j], 0) << robot::kJointNames[j];
    // The stops still hold: a limp leg carries the trunk on them.
    EXPECT_GT(seen.position_rad[j], robot.joints[j].min_rad - 0.1) << robot::kJointNames[j];
    EXPECT_LT(seen.position_rad[j], robot.joints[j].max_rad + 0.1) << robot::kJointNames[j];
  }
}

TEST(Power, OfOneServoIsItsOwnMatter) {
  Simulation simulation(beetle(), default_config(), {});
  Powered all_but_one = Powered().set();
  all_but_one.reset(kLeft);
  simulation.power(all_but_one);
  robot::JointVector targets = stance();
  targets[kLeft] += 0.4;
  targets[kRight] += 0.4;
  run(simulation, targets, 10);
  const Observation seen = simulation.observe();
  EXPECT_LT(seen.position_rad[kLeft], stance()[kLeft] + 0.05) << "a middle leg: it hangs";
  EXPECT_NEAR(seen.position_rad[kRight], targets[kRight], 0.15);
}

/// The servo begins from where the joint is: towards its goal at its speed, and with no blow.
TEST(Power, ThatComesBackMovesTheJointNoFasterThanItsServo) {
  PlantConfig config = default_config();
  config.timing.control_period_s = config.timing.sensor_period_s = 0.002;
  robot::RobotModel robot = beetle();
  robot.joints[kLeft].velocity_max_rad_s = 1;
  robot::JointVector raised = stance();
  raised[kLeft] += 0.4;
  Simulation simulation(robot, config, {});
  Powered powered = Powered().set();
  powered.reset(kLeft);
  simulation.power(powered);
  run(simulation, raised, 500);
  ASSERT_LT(simulation.observe().position_rad[kLeft], stance()[kLeft] + 0.1) << "limp";

  simulation.power(Powered().set());
  double fastest_rad_s = 0;
  for (int step = 0; step < 500; ++step) {
    simulation.advance(raised, nullptr);
    fastest_rad_s = std::max(fastest_rad_s, simulation.observe().velocity_rad_s[kLeft]);
  }
  EXPECT_GT(fastest_rad_s, 0.5);
  EXPECT_LT(fastest_rad_s, 1.5);
  EXPECT_NEAR(simulation.observe().position_rad[kLeft], raised[kLeft], 0.15);
}

TEST(StartPose, IsWhereTheJointsAreAtTheStart) {
  robot::JointVector pose = stance();
  pose[kLeft] -= 0.3;
  const Simulation moved(beetle(), default_config(), {}, pose);
  const Simulation plain(beetle(), default_config(), {});
  EXPECT_NEAR(plain.observe().position_rad[kLeft] - moved.observe().position_rad[kLeft], 0.3, 0.1);
  EXPECT_NEAR(plain.observe().position_rad[kRight], moved.observe().position_rad[kRight], 0.1);
}

}  // namespace
}  // namespace scarab::plant
