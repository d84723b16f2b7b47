// A robot without a backbone: where its file says a hinge would be makes no difference.
#include <gtest/gtest.h>

#include <cmath>

#include "common/config/robot_file.hpp"
#include "services/plant/config.hpp"
#include "services/plant/core/scene.hpp"
#include "services/plant/core/simulation.hpp"

namespace scarab::plant {
namespace {

constexpr double kClose = 1e-8;  // rounding, grown over 1000 steps with contact

robot::RobotModel phantomx() {
  return config::load_robot(SCARAB_SOURCE_DIR "/config/robot/phantomx.yaml");
}

/// Ground truth after a second of swinging and lifting legs.
WorldTruth stepped(const robot::RobotModel& robot) {
  const PlantConfig config = load_config(SCARAB_SOURCE_DIR "/config/plant/phantomx.yaml");
  Simulation simulation(robot, config, {});
  for (int tick = 0; tick < 10; ++tick) {
    robot::JointVector targets = start_targets(config.start);
    for (const robot::Leg leg : robot::kLegs) {
      const double phase = 0.5 * tick + (tripod_sign(leg) > 0 ? 0 : M_PI);
      targets[joint_slot(leg, robot::LegJoint::kThoracoCoxal)] += 0.3 * std::sin(phase);
      targets[joint_slot(leg, robot::LegJoint::kCoxaTrochanteral)] +=
          0.2 * std::max(0.0, std::cos(phase));
    }
    simulation.advance(targets, nullptr);
  }
  return simulation.truth();
}

void expect_same_motion(const WorldTruth& a, const WorldTruth& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.trunk.position_m[i], b.trunk.position_m[i], kClose);
    EXPECT_NEAR(a.trunk_twist.linear_m_s[i], b.trunk_twist.linear_m_s[i], 100 * kClose);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(a.trunk.orientation_wxyz[i], b.trunk.orientation_wxyz[i], kClose);
  }
}

TEST(RigidTrunk, MovesAlikeWhereverTheHingeWouldBe) {
  const robot::RobotModel robot = phantomx();
  const WorldTruth whole = stepped(robot);
  EXPECT_GT(std::hypot(whole.trunk_twist.linear_m_s[0], whole.trunk_twist.linear_m_s[1]), 0.01)
      << "it moves";
  for (const double hinge_x_m : {0.01, 0.1}) {
    robot::RobotModel divided = robot;
    divided.trunk.hinge_x_m = hinge_x_m;
    expect_same_motion(stepped(divided), whole);
  }
}

TEST(RigidTrunk, MovesAlikeWhicheverPartTheLegsHangOn) {
  robot::RobotModel robot = phantomx();
  const WorldTruth whole = stepped(robot);
  robot.rows[0].on_front_segment = false;
  expect_same_motion(stepped(robot), whole);
}

TEST(RigidTrunk, IsNotWhatABackboneMakes) {
  robot::RobotModel robot = phantomx();
  const WorldTruth whole = stepped(robot);
  robot.joints[robot::kBackboneSlot] = robot.joints[0];  // a servo as the legs'
  const WorldTruth hinged = stepped(robot);
  EXPECT_GT(std::abs(hinged.trunk.position_m[2] - whole.trunk.position_m[2]), 1e-4);
}

}  // namespace
}  // namespace scarab::plant
