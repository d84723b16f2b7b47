#include "services/plant/core/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

TEST(Perturbation, StaysWithinItsBoundsAndFillsThem) {
  TrialSpec trial;
  trial.perturb_position_m = 0.01;
  trial.perturb_yaw_rad = 0.035;
  double widest_x = 0, widest_yaw = 0;
  std::set<double> seen;
  for (trial.seed = 0; trial.seed < 200; ++trial.seed) {
    const Perturbation p = perturbation(trial);
    EXPECT_LE(std::abs(p.x_m), 0.01);
    EXPECT_LE(std::abs(p.y_m), 0.01);
    EXPECT_LE(std::abs(p.yaw_rad), 0.035);
    widest_x = std::max(widest_x, std::abs(p.x_m));
    widest_yaw = std::max(widest_yaw, std::abs(p.yaw_rad));
    seen.insert(p.y_m);
  }
  EXPECT_GT(widest_x, 0.009);
  EXPECT_GT(widest_yaw, 0.031);
  EXPECT_EQ(seen.size(), 200U);
}

TEST(Perturbation, DependsOnTheSeedAlone) {
  TrialSpec trial;
  trial.seed = 7;
  trial.perturb_position_m = 0.01;
  const Perturbation first = perturbation(trial);
  trial.obstacle_height_m = 0.1;
  trial.goal = Goal::kAcross;
  EXPECT_EQ(perturbation(trial).x_m, first.x_m);
  trial.perturb_position_m = 0.02;
  EXPECT_DOUBLE_EQ(perturbation(trial).x_m, 2 * first.x_m);
}

TEST(SceneConfig, IsTheConfigurationWhereTheTrialSaysNothing) {
  const PlantConfig config = testing::default_config();
  const PlantConfig scene = scene_config(config, TrialSpec{});
  EXPECT_EQ(scene.friction.foot_object, config.friction.foot_object);
  EXPECT_EQ(scene.object.mass_kg, config.object.mass_kg);
  EXPECT_EQ(scene.object.diameter_m, config.object.diameter_m);
  EXPECT_EQ(scene.object.start_distance_m, config.object.start_distance_m);
}

TEST(SceneConfig, FrictionIsScaledAndPerturbedEachForItself) {
  const PlantConfig config = testing::default_config();
  TrialSpec trial;
  trial.friction_scale = 1.25;
  EXPECT_DOUBLE_EQ(scene_config(config, trial).friction.foot_ground,
                   1.25 * config.friction.foot_ground);
  trial.friction_scale = 0;
  trial.perturb_friction = 0.1;
  double widest = 0;
  std::set<double> together;
  for (trial.seed = 0; trial.seed < 200; ++trial.seed) {
    const FrictionConfig friction = scene_config(config, trial).friction;
    const double foot = friction.foot_ground / config.friction.foot_ground;
    const double object = friction.object_obstacle / config.friction.object_obstacle;
    EXPECT_LE(std::abs(foot - 1), 0.1 + 1e-12);
    widest = std::max(widest, std::abs(foot - 1));
    together.insert(foot - object);
  }
  EXPECT_GT(widest, 0.09);
  EXPECT_EQ(together.size(), 200U) << "the coefficients vary independently of each other";
}

TEST(SceneConfig, TakesTheTrialsObject) {
  TrialSpec trial;
  trial.object_mass_kg = 3;
  trial.object_diameter_m = 0.22;
  const PlantConfig scene = scene_config(testing::default_config(), trial);
  EXPECT_EQ(scene.object.mass_kg, 3);
  const Morphology morphology = make_morphology(testing::beetle(), scene.object);
  EXPECT_DOUBLE_EQ(morphology.object_radius_m, 0.11);
  EXPECT_DOUBLE_EQ(make_wall(scene, trial).x, -(0.5 + 0.11 + 0.8));
}

TEST(SceneConfig, AWalkHasNoObjectInItsWay) {
  TrialSpec trial;
  trial.goal = Goal::kWalk;
  trial.goal_distance_m = 3;
  EXPECT_GT(scene_config(testing::default_config(), trial).object.start_distance_m, 4);
}

TEST(SceneConfig, RefusesWhatCannotBe) {
  const PlantConfig config = testing::default_config();
  const auto refused = [&](auto change) {
    TrialSpec trial;
    change(trial);
    EXPECT_THROW(static_cast<void>(scene_config(config, trial)), std::invalid_argument);
  };
  refused([](TrialSpec& t) { t.friction_scale = -1; });
  refused([](TrialSpec& t) { t.object_mass_kg = std::nan(""); });
  refused([](TrialSpec& t) { t.object_diameter_m = -0.1; });
  refused([](TrialSpec& t) { t.perturb_friction = 1; });
  refused([](TrialSpec& t) { t.perturb_friction = -0.1; });
}

TEST(Scene, StandsAsTheTaskSays) {
  const PlantConfig config = testing::default_config();
  TrialSpec trial;
  trial.obstacle_height_m = 0.1;
  const Wall wall = make_wall(config, trial);
  EXPECT_NEAR(wall.x, -1.39, 1e-12);
  EXPECT_EQ(wall.height, 0.1);
  const Morphology morphology = make_morphology(testing::beetle(), config.object);
  const MotionState state = start_state(morphology, config, {0.003, -0.002, 0.02});
  EXPECT_NEAR(state.object_position.x(), -0.5, 1e-12);
  EXPECT_NEAR(state.object_position.z(), 0.09, 1e-12);
  EXPECT_NEAR(state.trunk_position.x(), 0.003, 1e-12);
  EXPECT_NEAR(state.trunk_position.y(), -0.002, 1e-12);
  EXPECT_GT(state.trunk_position.z(), 0.06);
  EXPECT_LT(state.trunk_position.z(), 0.12);
}

TEST(Morphology, RefusesWhatHasNoSize) {
  robot::RobotModel robot = testing::beetle();
  robot.rows[1].femur.length_m = 0;
  EXPECT_THROW(static_cast<void>(make_morphology(robot, testing::default_config().object)),
               std::invalid_argument);
  PlantConfig config = testing::default_config();
  config.object.mass_kg = -1;
  EXPECT_THROW(static_cast<void>(make_morphology(testing::beetle(), config.object)),
               std::invalid_argument);
}

/// Where a joint takes the foot, in the trunk's frame.
Eigen::Vector3d foot(robot::Leg leg, robot::LegJoint joint, double angle) {
  const Morphology morphology =
      make_morphology(testing::plain_walker(), testing::default_config().object);
  MotionState state;
  state.joint_rad[joint_slot(leg, joint)] = angle;
  const std::size_t tibia = leg_body(leg, LegSegment::kTibia);
  return testing::kinematics_of(morphology, state)
      .body[tibia]
      .to_world(morphology.segment[tibia].tip);
}

TEST(Morphology, JointSignsAreTheProjects) {
  for (const robot::Leg leg : robot::kLegs) {
    const Eigen::Vector3d straight = foot(leg, robot::LegJoint::kThoracoCoxal, 0);
    EXPECT_NEAR(std::abs(straight.y()), 0.035 + 0.045 + 0.035 + 0.06 + 0.115, 1e-9);
    EXPECT_EQ(straight.y() > 0, robot::is_left(leg));
    EXPECT_GT((foot(leg, robot::LegJoint::kThoracoCoxal, 0.3) - straight).x(), 0.05) << "forward";
    EXPECT_GT((foot(leg, robot::LegJoint::kCoxaTrochanteral, 0.3) - straight).z(), 0.04) << "up";
    EXPECT_LT((foot(leg, robot::LegJoint::kFemurTibia, 0.3) - straight).z(), -0.03) << "down";
  }
}

TEST(Morphology, BackboneRaisesTheRear) {
  const Morphology morphology =
      make_morphology(testing::beetle(), testing::default_config().object);
  MotionState state;
  state.joint_rad[robot::kBackboneSlot] = 0.2;
  const Kinematics kinematics = testing::kinematics_of(morphology, state);
  // Against a level rear the front points up: seen from the front, the rear is raised.
  EXPECT_GT(kinematics.body[kFrontTrunkBody].R_world_body(2, 0), 0.19);
}

TEST(Morphology, WeighsWhatItsPartsWeigh) {
  const robot::RobotModel robot = testing::beetle();
  double expected = robot.trunk.mass_kg;
  for (const robot::LegRow& row : robot.rows) {
    expected +=
        2 * (row.shoulder.mass_kg + row.coxa.mass_kg + row.femur.mass_kg + row.tibia.mass_kg);
  }
  EXPECT_NEAR(testing::robot_mass(make_morphology(robot, testing::default_config().object)),
              expected, 1e-12);
}

}  // namespace
}  // namespace scarab::plant
