#include "services/plant/core/sensor_readings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scarab::plant {
namespace {

constexpr std::int64_t kStepNs = 2'000'000;
constexpr std::uint64_t kStepsPerSample = 10;
constexpr std::size_t kSensors = 8;

JointPresence all_present() {
  JointPresence present{};
  present.fill(true);
  return present;
}

/// Every signal reads `value`.
Observation constant(double value) {
  Observation out;
  out.position_rad.fill(value);
  out.velocity_rad_s.fill(value);
  out.torque_nm.fill(value);
  out.foot_force_n.fill(value);
  out.roll_rad = out.pitch_rad = value;
  out.angular_velocity_rad_s.fill(value);
  out.acceleration_m_s2.fill(value);
  out.supply_current_a = value;
  return out;
}

/// All numbers of an observation, sensor by sensor.
std::vector<std::vector<double>> by_sensor(const Observation& seen) {
  const auto list = [](const auto& values) {
    return std::vector<double>(values.begin(), values.end());
  };
  return {list(seen.position_rad),
          list(seen.velocity_rad_s),
          list(seen.torque_nm),
          list(seen.foot_force_n),
          {seen.roll_rad, seen.pitch_rad},
          list(seen.angular_velocity_rad_s),
          list(seen.acceleration_m_s2),
          {seen.supply_current_a}};
}

/// The errors of each sensor, in the order of by_sensor().
std::vector<SensorErrors*> errors_of(SensorsConfig& config) {
  return {&config.joint_position, &config.joint_velocity, &config.joint_torque,
          &config.foot_force,     &config.inclination,    &config.angular_velocity,
          &config.acceleration,   &config.supply_current};
}

/// Readings of samples 0.. while the truth after step s is `s` everywhere.
std::vector<Observation> of_a_ramp(const SensorsConfig& config, std::uint64_t samples,
                                   std::uint64_t seed = 1) {
  SensorReadings readings(config, all_present(), seed, kStepNs);
  std::vector<Observation> out;
  readings.see(constant(0));
  for (std::uint64_t n = 0; n < samples; ++n) {
    if (n > 0) {
      for (std::uint64_t k = 1; k <= kStepsPerSample; ++k) {
        readings.see(constant(static_cast<double>((n - 1) * kStepsPerSample + k)));
      }
    }
    readings.sample(n);
    out.push_back(readings.newest());
  }
  return out;
}

TEST(SensorReadings, IdealSensorsReadTheTruth) {
  const auto seen = of_a_ramp({}, 4);
  for (std::size_t n = 0; n < seen.size(); ++n) {
    EXPECT_EQ(by_sensor(seen[n]), by_sensor(constant(static_cast<double>(n * kStepsPerSample))));
  }
}

TEST(SensorReadings, EverySensorHasItsOwnErrors) {
  for (std::size_t disturbed = 0; disturbed < kSensors; ++disturbed) {
    SensorsConfig config;
    errors_of(config)[disturbed]->bias = 1;
    const auto seen = by_sensor(of_a_ramp(config, 3)[2]);
    const auto truth = by_sensor(constant(2.0 * kStepsPerSample));
    for (std::size_t sensor = 0; sensor < kSensors; ++sensor) {
      for (std::size_t i = 0; i < seen[sensor].size(); ++i) {
        EXPECT_EQ(seen[sensor][i] == truth[sensor][i], sensor != disturbed)
            << "sensor " << sensor << " with sensor " << disturbed << " disturbed";
      }
    }
  }
}

TEST(SensorReadings, LatencyShiftsByExactlyItsSteps) {
  for (std::size_t delayed = 0; delayed < kSensors; ++delayed) {
    for (const std::size_t steps : {1U, 7U, 10U, 25U}) {
      SensorsConfig config;
      errors_of(config)[delayed]->latency_s = 0.002 * static_cast<double>(steps);
      const auto seen = of_a_ramp(config, 8);
      for (std::size_t n = 0; n < seen.size(); ++n) {
        const double now = static_cast<double>(n * kStepsPerSample);
        const double then = std::max(0.0, now - static_cast<double>(steps));
        const auto values = by_sensor(seen[n]);
        for (std::size_t sensor = 0; sensor < kSensors; ++sensor) {
          for (const double value : values[sensor]) {
            EXPECT_EQ(value, sensor == delayed ? then : now);
          }
        }
      }
    }
  }
}

TEST(SensorReadings, ALostSampleLeavesTheLastReading) {
  SensorsConfig config;
  config.joint_position.dropout = 0.3;
  config.joint_position.noise = 0.01;
  const auto seen = of_a_ramp(config, 4000);
  std::size_t held = 0;
  for (std::size_t n = 1; n < seen.size(); ++n) {
    const double fresh = static_cast<double>(n * kStepsPerSample);
    if (seen[n].position_rad[0] == seen[n - 1].position_rad[0]) {
      ++held;
    } else {
      EXPECT_NEAR(seen[n].position_rad[0], fresh, 0.06) << n;
    }
  }
  EXPECT_NEAR(static_cast<double>(held) / static_cast<double>(seen.size()), 0.3, 0.03);
}

TEST(SensorReadings, JointsAndFeetLoseSamplesByThemselves) {
  SensorsConfig config;
  config.joint_position.dropout = config.foot_force.dropout = 0.5;
  const auto seen = of_a_ramp(config, 2000);
  std::size_t joints_differ = 0, feet_differ = 0;
  for (const Observation& sample : seen) {
    joints_differ += sample.position_rad[0] != sample.position_rad[1] ? 1 : 0;
    feet_differ += sample.foot_force_n[0] != sample.foot_force_n[1] ? 1 : 0;
  }
  // The ages of two readings are equal with probability sum_k 0.25^k = 1/3.
  EXPECT_NEAR(static_cast<double>(joints_differ) / 2000, 2.0 / 3, 0.06);
  EXPECT_NEAR(static_cast<double>(feet_differ) / 2000, 2.0 / 3, 0.06);
}

TEST(SensorReadings, AxesOfTheImuLoseSamplesTogether) {
  SensorsConfig config;
  config.inclination.dropout = config.angular_velocity.dropout = config.acceleration.dropout = 0.5;
  std::array<int, 3> held{};
  const auto seen = of_a_ramp(config, 1000);
  for (std::size_t n = 1; n < seen.size(); ++n) {
    EXPECT_EQ(seen[n].roll_rad, seen[n].pitch_rad);
    for (std::size_t axis : {1U, 2U}) {
      EXPECT_EQ(seen[n].acceleration_m_s2[axis], seen[n].acceleration_m_s2[0]);
      EXPECT_EQ(seen[n].angular_velocity_rad_s[axis], seen[n].angular_velocity_rad_s[0]);
    }
    const Observation &now = seen[n], &before = seen[n - 1];
    held[0] += now.roll_rad == before.roll_rad ? 1 : 0;
    held[1] += now.angular_velocity_rad_s == before.angular_velocity_rad_s ? 1 : 0;
    held[2] += now.acceleration_m_s2 == before.acceleration_m_s2 ? 1 : 0;
  }
  for (const int times : held) EXPECT_NEAR(times, 500, 70);
}

TEST(SensorReadings, AFootNeverPulls) {
  SensorsConfig config;
  config.foot_force.noise = 1;
  SensorReadings readings(config, all_present(), 1, kStepNs);
  readings.see(constant(0));
  std::size_t zero = 0;
  for (std::uint64_t n = 0; n < 500; ++n) {
    readings.sample(n);
    for (const double force : readings.newest().foot_force_n) {
      EXPECT_GE(force, 0);
      zero += force == 0 ? 1 : 0;
    }
  }
  EXPECT_NEAR(static_cast<double>(zero) / 3000, 0.5, 0.05);
}

TEST(SensorReadings, AbsentJointsReadZero) {
  JointPresence present = all_present();
  present[robot::kBackboneSlot] = false;
  SensorsConfig config;
  for (SensorErrors* errors : errors_of(config)) errors->bias = errors->noise = 1;
  SensorReadings readings(config, present, 1, kStepNs);
  readings.see(constant(0));
  readings.sample(0);
  EXPECT_EQ(readings.newest().position_rad[robot::kBackboneSlot], 0);
  EXPECT_EQ(readings.newest().velocity_rad_s[robot::kBackboneSlot], 0);
  EXPECT_EQ(readings.newest().torque_nm[robot::kBackboneSlot], 0);
  EXPECT_NE(readings.newest().position_rad[0], 0);
}

TEST(SensorReadings, AnEncodersOffsetIsWhatItReadsTooMuch) {
  JointPresence present = all_present();
  present[robot::kBackboneSlot] = false;
  SensorsConfig config;
  config.joint_position.bias = 0.01;
  SensorReadings readings(config, present, 1, kStepNs);
  readings.see(constant(1));
  readings.sample(0);
  const robot::JointVector offset = readings.encoder_offset_rad();
  EXPECT_EQ(offset[robot::kBackboneSlot], 0);
  for (std::size_t j = 0; j < robot::kBackboneSlot; ++j) {
    EXPECT_NE(offset[j], 0);
    EXPECT_DOUBLE_EQ(readings.newest().position_rad[j], 1 + offset[j]);
  }
}

TEST(SensorReadings, EveryStepIsNeededForALatencyOnly) {
  SensorsConfig config;
  config.joint_position = {{0.1, 0.1, 0.1, 0, 0.1}};
  EXPECT_FALSE(SensorReadings(config, all_present(), 1, kStepNs).needs_every_step());
  config.acceleration.latency_s = 0.002;
  EXPECT_TRUE(SensorReadings(config, all_present(), 1, kStepNs).needs_every_step());
}

TEST(SensorReadings, RefuseALatencyBetweenSteps) {
  SensorsConfig config;
  config.foot_force.latency_s = 0.003;
  try {
    SensorReadings(config, all_present(), 1, kStepNs);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "foot_force latency_s is not a whole number of steps (step_s)");
  }
  config.foot_force.latency_s = -0.002;
  EXPECT_THROW(SensorReadings(config, all_present(), 1, kStepNs), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::plant
