#include "services/plant/core/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "services/plant/core/scene.hpp"
#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using testing::beetle;
using testing::default_config;

TrialSpec trial(std::uint64_t seed) {
  TrialSpec out;
  out.seed = seed;
  out.perturb_position_m = 0.01;
  out.perturb_yaw_rad = 0.035;
  out.obstacle_height_m = 0.1;
  return out;
}

/// A clumsy walk into the object.
robot::JointVector targets_at(int tick) {
  robot::JointVector targets = start_targets(default_config().start);
  for (const robot::Leg leg : robot::kLegs) {
    const double phase = 0.5 * tick;
    targets[joint_slot(leg, robot::LegJoint::kThoracoCoxal)] -=
        0.4 * tripod_sign(leg) * std::sin(phase);
    targets[joint_slot(leg, robot::LegJoint::kCoxaTrochanteral)] +=
        0.4 * std::max(0.0, tripod_sign(leg) * std::cos(phase));
  }
  return targets;
}

/// Every number the simulation tells over some seconds.
std::vector<double> record(std::uint64_t seed, int ticks) {
  PlantConfig config = default_config();
  config.sensors.joint_position.noise = 0.001;
  Simulation simulation(beetle(), config, trial(seed));
  std::vector<double> out;
  const auto sample = [&] {
    const Observation seen = simulation.observe();
    const WorldTruth truth = simulation.truth();
    for (const auto& values : {seen.position_rad, seen.velocity_rad_s, seen.torque_nm}) {
      out.insert(out.end(), values.begin(), values.end());
    }
    out.insert(out.end(), seen.foot_force_n.begin(), seen.foot_force_n.end());
    out.insert(out.end(), seen.acceleration_m_s2.begin(), seen.acceleration_m_s2.end());
    out.insert(out.end(), truth.object.position_m.begin(), truth.object.position_m.end());
    for (const ContactTruth& contact : truth.contacts) {
      out.insert(out.end(), contact.force_n.begin(), contact.force_n.end());
    }
  };
  for (int tick = 0; tick < ticks; ++tick) {
    sample();
    simulation.advance(targets_at(tick), sample);
  }
  return out;
}

TEST(Simulation, IsBitIdenticalFromRunToRun) {
  const std::vector<double> first = record(5, 40);
  EXPECT_EQ(first, record(5, 40));
  EXPECT_NE(first, record(6, 40));
}

TEST(Simulation, SamplesBetweenTicksOnly) {
  Simulation simulation(beetle(), default_config(), trial(1));
  std::vector<std::int64_t> times;
  const auto sample = [&] { times.push_back(simulation.time_ns()); };
  simulation.advance(targets_at(0), sample);
  EXPECT_EQ(times, (std::vector<std::int64_t>{20'000'000, 40'000'000, 60'000'000, 80'000'000}));
  EXPECT_EQ(simulation.time_ns(), 100'000'000);
  simulation.advance(targets_at(1), nullptr);
  EXPECT_EQ(simulation.time_ns(), 200'000'000);
}

TEST(Simulation, SamplingDoesNotChangeTheMotion) {
  Simulation watched(beetle(), default_config(), trial(1));
  Simulation alone(beetle(), default_config(), trial(1));
  for (int tick = 0; tick < 10; ++tick) {
    watched.advance(targets_at(tick), [&] { static_cast<void>(watched.truth()); });
    alone.advance(targets_at(tick), nullptr);
  }
  EXPECT_EQ(watched.truth().trunk.position_m, alone.truth().trunk.position_m);
}

TEST(Simulation, LatchesTheVerdict) {
  TrialSpec spec = trial(1);
  spec.time_limit_s = 0.5;
  Simulation simulation(beetle(), default_config(), spec);
  for (int tick = 0; tick < 4; ++tick) {
    simulation.advance(targets_at(tick), nullptr);
    EXPECT_EQ(simulation.truth().verdict, Verdict::kOpen);
  }
  for (int tick = 4; tick < 7; ++tick) {
    simulation.advance(targets_at(tick), nullptr);
    EXPECT_EQ(simulation.truth().verdict, Verdict::kSuccess);
    EXPECT_NEAR(simulation.truth().verdict_time_s, 0.5, 1e-12);
    EXPECT_EQ(simulation.truth().verdict_reason, "ran to the time limit of 0.5 s");
  }
}

TEST(Simulation, TellsTheObstacle) {
  EXPECT_TRUE(Simulation(beetle(), default_config(), trial(1)).truth().obstacle_present);
  EXPECT_NEAR(Simulation(beetle(), default_config(), trial(1)).truth().obstacle_x_m, -1.39, 1e-12);
  EXPECT_FALSE(Simulation(beetle(), default_config(), {}).truth().obstacle_present);
}

TEST(Simulation, ForcesOnTheObjectAddUp) {
  const Simulation simulation(beetle(), default_config(), trial(1));
  double up = 0;
  for (const ContactTruth& contact : simulation.truth().contacts) {
    if (contact.solid_b == Solid::kObject) up += contact.force_n[2];
  }
  EXPECT_NEAR(up, 2 * 9.81, 0.02);
}

TEST(Simulation, RefusesPeriodsThatDoNotDivide) {
  PlantConfig config = default_config();
  config.timing.step_s = 0.003;
  EXPECT_THROW(Simulation(beetle(), config, {}), std::invalid_argument);
  config.timing.step_s = 0;
  EXPECT_THROW(Simulation(beetle(), config, {}), std::invalid_argument);
}

TEST(Simulation, ACommandOneTickLateMovesTheRobotOneTickLater) {
  PlantConfig late_config = default_config();
  late_config.commands.latency_s = late_config.timing.control_period_s;
  Simulation late(beetle(), late_config, trial(1));
  Simulation prompt(beetle(), default_config(), trial(1));
  prompt.advance(start_targets(default_config().start), nullptr);
  for (int tick = 0; tick < 8; ++tick) {
    late.advance(targets_at(tick), nullptr);
    if (tick > 0) prompt.advance(targets_at(tick - 1), nullptr);
    EXPECT_EQ(late.observe().position_rad, prompt.observe().position_rad) << tick;
  }
}

TEST(Simulation, StopsWhenTheMotionIsNotFinite) {
  Simulation simulation(beetle(), default_config(), {});
  robot::JointVector targets = targets_at(0);
  targets[3] = std::nan("");
  EXPECT_THROW(simulation.advance(targets, nullptr), std::runtime_error);
}

}  // namespace
}  // namespace scarab::plant
