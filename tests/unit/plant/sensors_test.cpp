#include "services/plant/core/sensors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/plant/core/simulation.hpp"
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

TEST(SensorNoise, HasItsDeviationAndIsReproducible) {
  const PlantConfig config = testing::default_config();
  const Morphology morphology = make_morphology(testing::beetle(), config.object);
  SensorNoiseConfig noise;
  noise.position_rad = 0.01;
  noise.inclination_rad = 0.02;
  double square = 0, mean = 0, inclination = 0;
  const int samples = 500;
  for (int i = 0; i < samples; ++i) {
    Observation seen, again;
    add_noise(noise, morphology, 3, static_cast<std::uint64_t>(i), seen);
    add_noise(noise, morphology, 3, static_cast<std::uint64_t>(i), again);
    EXPECT_EQ(seen.position_rad, again.position_rad);
    for (const double p : seen.position_rad) {
      square += p * p;
      mean += p;
    }
    inclination += seen.pitch_rad * seen.pitch_rad + seen.roll_rad * seen.roll_rad;
    EXPECT_EQ(seen.torque_nm[0], 0) << "a sensor without noise is left alone";
  }
  const double count = samples * static_cast<double>(robot::kJointCount);
  EXPECT_NEAR(std::sqrt(square / count), 0.01, 3e-4);
  EXPECT_NEAR(mean / count, 0, 4e-4);
  EXPECT_NEAR(std::sqrt(inclination / (2 * samples)), 0.02, 1.5e-3);
}

TEST(SensorNoise, DoesNotTouchThePhysics) {
  PlantConfig noisy = testing::default_config();
  noisy.noise = {0.01, 0.1, 0.1, 1, 0.01, 0.01, 0.1};
  TrialSpec trial;
  Simulation clean(testing::beetle(), testing::default_config(), trial);
  Simulation disturbed(testing::beetle(), noisy, trial);
  const robot::JointVector targets = start_targets(noisy.start);
  for (int tick = 0; tick < 5; ++tick) {
    clean.advance(targets, nullptr);
    disturbed.advance(targets, nullptr);
  }
  EXPECT_EQ(clean.truth().trunk.position_m, disturbed.truth().trunk.position_m);
  EXPECT_NE(clean.observe().position_rad, disturbed.observe().position_rad);
}

}  // namespace
}  // namespace scarab::plant
