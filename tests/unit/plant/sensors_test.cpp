#include "services/plant/core/sensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/plant/core/scene.hpp"
#include "services/plant/core/sensor_readings.hpp"
#include "services/plant/core/simulation.hpp"
#include "services/plant/core/supply_current.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using Eigen::Vector3d;

Observation at_rest(const PlantConfig& config, std::uint64_t seed = 0) {
  TrialSpec trial;
  trial.seed = seed;
  return Simulation(testing::beetle(), config, trial).observe();
}

Observation tilted(const Vector3d& axis, double angle) {
  testing::Rig rig(testing::beetle(), testing::default_config());
  rig.state.trunk_orientation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  return measure(rig.morphology, rig.state, rig.stepper, 9.81);
}

TEST(Sensors, AtRestTheSpecificForceIsGravity) {
  const Observation seen = at_rest(testing::default_config());
  EXPECT_NEAR(Vector3d(seen.acceleration_m_s2.data()).norm(), 9.81, 0.01);
  EXPECT_GT(seen.acceleration_m_s2[2], 9.7);
  EXPECT_NEAR(Vector3d(seen.angular_velocity_rad_s.data()).norm(), 0, 5e-3);
}

TEST(Sensors, PitchIsPositiveWithTheRearUp) {
  EXPECT_NEAR(tilted(Vector3d::UnitY(), 0.2).pitch_rad, 0.2, 1e-12);
  EXPECT_NEAR(tilted(Vector3d::UnitY(), 0.2).roll_rad, 0, 1e-12);
}

TEST(Sensors, RollIsPositiveWithTheLeftSideUp) {
  EXPECT_NEAR(tilted(Vector3d::UnitX(), 0.2).roll_rad, 0.2, 1e-12);
  EXPECT_NEAR(tilted(Vector3d::UnitX(), 0.2).pitch_rad, 0, 1e-12);
}

TEST(Sensors, HeadingIsNoInclination) {
  const Observation seen = tilted(Vector3d::UnitZ(), 1.0);
  EXPECT_NEAR(seen.roll_rad, 0, 1e-12);
  EXPECT_NEAR(seen.pitch_rad, 0, 1e-12);
}

TEST(Sensors, TheSupplyCurrentIsWhatTheTorquesNeed) {
  const SupplyConfig supply{1.5, 2.0};
  robot::JointVector torque_nm{};
  EXPECT_EQ(supply_current_a(supply, torque_nm), 1.5);
  torque_nm[3] = 4;
  torque_nm[robot::kBackboneSlot] = -1;
  EXPECT_DOUBLE_EQ(supply_current_a(supply, torque_nm), 1.5 + 2.5) << "either sense draws";
}

TEST(Sensors, AStandingRobotDrawsMoreThanAnIdleOne) {
  const PlantConfig config = testing::default_config();
  const Observation seen = at_rest(config);
  EXPECT_DOUBLE_EQ(seen.supply_current_a, supply_current_a(config.supply, seen.torque_nm));
  EXPECT_GT(seen.supply_current_a, config.supply.idle_a + 0.5);
}

/// A simulation with errors on every sensor.
PlantConfig noisy_config() {
  PlantConfig config = testing::default_config();
  config.sensors.joint_position.noise = 0.01;
  config.sensors.joint_velocity.noise = 0.1;
  config.sensors.inclination.latency_s = 0.01;
  config.sensors.acceleration.bias = 0.1;
  config.sensors.foot_force.dropout = 0.5;
  return config;
}

TEST(Sensors, ErrorsDoNotTouchThePhysics) {
  Simulation clean(testing::beetle(), testing::default_config(), {});
  Simulation disturbed(testing::beetle(), noisy_config(), {});
  const robot::JointVector targets = start_targets(noisy_config().start);
  for (int tick = 0; tick < 5; ++tick) {
    clean.advance(targets, nullptr);
    disturbed.advance(targets, nullptr);
  }
  EXPECT_EQ(clean.truth().trunk.position_m, disturbed.truth().trunk.position_m);
  EXPECT_NE(clean.observe().position_rad, disturbed.observe().position_rad);
}

/// A servo cannot know that its encoder is off: it turns the joint until the encoder reads the
/// target, so the error is in the pose and not in the reading.
TEST(Sensors, AnEncodersOffsetMovesTheJointAndNotTheReading) {
  PlantConfig off_config = testing::default_config();
  off_config.sensors.joint_position.bias = 0.02;
  const auto still = [](PlantConfig config) {
    config.start.settle_s = 3;
    return Simulation(testing::beetle(), config, {}).observe();
  };
  const Observation clean = still(testing::default_config()), off = still(off_config);
  const JointPresence present = [] {
    JointPresence all{};
    all.fill(true);
    return all;
  }();
  const robot::JointVector offset =
      SensorReadings(off_config.sensors, present, 0, 2'000'000).encoder_offset_rad();
  double reading_moved = 0, joint_moved = 0, bias = 0;
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    const double change = off.position_rad[j] - clean.position_rad[j];
    reading_moved += change * change;
    joint_moved += (change - offset[j]) * (change - offset[j]);
    bias += offset[j] * offset[j];
  }
  EXPECT_GT(std::sqrt(joint_moved / bias), 0.7);
  EXPECT_LT(std::sqrt(reading_moved / bias), 0.5) << "what is left: the feet share the load anew";
}

TEST(Sensors, ReadTheSameHoweverOftenTheyAreAsked) {
  Simulation asked_often(testing::beetle(), noisy_config(), {});
  Simulation asked_once(testing::beetle(), noisy_config(), {});
  const robot::JointVector targets = start_targets(noisy_config().start);
  for (int tick = 0; tick < 5; ++tick) {
    asked_often.advance(targets, [&] {
      const Observation first = asked_often.observe();
      EXPECT_EQ(asked_often.observe().position_rad, first.position_rad);
      EXPECT_EQ(asked_often.observe().foot_force_n, first.foot_force_n);
    });
    asked_once.advance(targets, nullptr);
  }
  const Observation often = asked_often.observe(), once = asked_once.observe();
  EXPECT_EQ(often.position_rad, once.position_rad);
  EXPECT_EQ(often.velocity_rad_s, once.velocity_rad_s);
  EXPECT_EQ(often.foot_force_n, once.foot_force_n);
  EXPECT_EQ(often.pitch_rad, once.pitch_rad);
  EXPECT_EQ(often.acceleration_m_s2, once.acceleration_m_s2);
}

}  // namespace
}  // namespace scarab::plant
