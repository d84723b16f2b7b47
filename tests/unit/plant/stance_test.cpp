// The robot standing: creep, weight, stops, torque limits, absent joints.
#include <gtest/gtest.h>

#include <cmath>

#include "services/plant/core/simulation.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using testing::Rig;

double sum(const robot::LegVector& values) {
  double out = 0;
  for (const double value : values) out += value;
  return out;
}

/// How far the trunk moves in ten seconds of standing, after one to settle, m.
double creep(Rig& rig) {
  rig.run(1, 0.002);
  const Eigen::Vector3d start = rig.state.trunk_position;
  rig.run(10, 0.002);
  return (rig.state.trunk_position - start).norm();
}

/// All legs straight out sideways: each of them carries its share.
PlantConfig plain_stance() {
  PlantConfig config = testing::default_config();
  config.start.front_rad = config.start.middle_rad = config.start.hind_rad = {0, 0, 1.4};
  config.start.backbone_rad = 0;
  return config;
}

TEST(Stance, DoesNotCreepInTenSeconds) {
  Rig rig(testing::plain_walker(), plain_stance());
  EXPECT_LT(creep(rig), 1e-3);
}

TEST(Stance, AnchorsHoldASplayedStance) {
  // The beetle's legs brace against each other, so that regularised friction alone lets them slide
  // apart.
  PlantConfig config = testing::default_config();
  Rig creeping(testing::beetle(), config);
  config.contact.anchor_stiffness_n_m = 1e4;
  Rig held(testing::beetle(), config);
  EXPECT_GT(creep(creeping), 1e-3);
  EXPECT_LT(creep(held), 1e-4);
}

TEST(Stance, FeetCarryTheWeight) {
  const PlantConfig config = plain_stance();
  const robot::RobotModel robot = testing::plain_walker();
  Simulation simulation(robot, config, {});
  for (int tick = 0; tick < 20; ++tick) simulation.advance(start_targets(config.start), nullptr);
  const double weight =
      testing::robot_mass(make_morphology(robot, config.object)) * config.gravity_m_s2;
  const Observation seen = simulation.observe();
  EXPECT_NEAR(sum(seen.foot_force_n), weight, 1e-3 * weight);
  for (const double force : seen.foot_force_n) EXPECT_GT(force, 0.02 * weight);
}

TEST(Stance, TheTrialStartsAtRest) {
  const Simulation simulation(testing::beetle(), testing::default_config(), {});
  EXPECT_EQ(simulation.time_ns(), 0);
  const WorldTruth truth = simulation.truth();
  for (const double v : truth.trunk_twist.linear_m_s) EXPECT_LT(std::abs(v), 1e-3);
  for (const double v : truth.object_twist.linear_m_s) EXPECT_LT(std::abs(v), 1e-3);
  EXPECT_EQ(truth.object_travel_m, 0);
  EXPECT_NEAR(truth.object.position_m[0], -0.5, 1e-3);
}

TEST(JointStop, HoldsAgainstTheServo) {
  Rig rig(testing::beetle(), testing::default_config());
  rig.remove_object();
  for (std::size_t j = 0; j < robot::kJointCount; ++j)
    rig.targets[j] = 10;  // far beyond every range
  rig.config.gravity_m_s2 = 0;
  rig.lift(5);
  rig.run(1, 0.002);
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    const robot::Joint& joint = rig.morphology.joints[j];
    const double give = joint.torque_max_nm / rig.config.joint_stop.stiffness_nm_rad;
    EXPECT_LT(rig.state.joint_rad[j], joint.max_rad + 1.5 * give) << robot::kJointNames[j];
    EXPECT_LE(std::abs(rig.stepper.servo_torque_nm()[j]), joint.torque_max_nm + 1e-9);
  }
}

TEST(AbsentJoint, IsRigid) {
  robot::RobotModel robot = testing::beetle();
  robot.joints[robot::kBackboneSlot].present = false;
  const PlantConfig config = testing::default_config();
  Simulation simulation(robot, config, {});
  for (int tick = 0; tick < 10; ++tick) simulation.advance(start_targets(config.start), nullptr);
  const Observation seen = simulation.observe();
  EXPECT_EQ(seen.position_rad[robot::kBackboneSlot], 0);
  EXPECT_EQ(seen.velocity_rad_s[robot::kBackboneSlot], 0);
  EXPECT_EQ(seen.torque_nm[robot::kBackboneSlot], 0);
  EXPECT_GT(sum(seen.foot_force_n), 40);  // it stands
}

}  // namespace
}  // namespace scarab::plant
