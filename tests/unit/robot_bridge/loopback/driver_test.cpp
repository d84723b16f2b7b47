#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "services/robot_bridge/drivers/loopback/config.hpp"

namespace scarab::bridge::loopback {
namespace {

using testing::HasSubstr;

constexpr std::size_t kTl0 = 0;
constexpr std::size_t kFl2 = 14;

robot::RobotModel fast_robot() {
  robot::RobotModel model;
  for (robot::Joint& joint : model.joints) joint.velocity_max_rad_s = 1000;
  model.joints[robot::kBackboneSlot].present = false;
  return model;
}

Calibration calibration() {
  Calibration result;
  for (std::size_t joint = 0; joint < robot::kBackboneSlot; ++joint) {
    result.joints[joint] = JointCalibration{0.1, -1, -2, 2};
  }
  return result;
}

std::unique_ptr<Driver> opened(const Config& config) {
  auto driver = make(config, fast_robot(), calibration(), "");
  driver->open();
  return driver;
}

robot::JointVector all_at(double rad) {
  robot::JointVector angles{};
  angles.fill(rad);
  return angles;
}

/// The first readings for which `wanted` holds, or those after 5 s.
template <class Wanted>
Readings read_until(Driver& driver, Wanted wanted) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  Readings readings = driver.read();
  while (!wanted(readings) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::yield();
    readings = driver.read();
  }
  return readings;
}

auto at(std::size_t joint, double rad) {
  return [=](const Readings& r) { return std::abs(r.position_rad.value[joint] - rad) < 1e-9; };
}

TEST(LoopbackDriver, MeasuresWhatItHas) {
  Config config;
  config.pose_rad["FL2"] = 0.7;
  const auto driver = opened(config);
  const Readings readings = driver->read();
  EXPECT_NEAR(readings.position_rad.value[kFl2], 0.7, 1e-12);
  EXPECT_EQ(readings.position_rad.source[kFl2], Source::kMeasured);
  EXPECT_EQ(readings.velocity_rad_s.source[kFl2], Source::kMeasured);
  EXPECT_EQ(readings.position_rad.source[robot::kBackboneSlot], Source::kAbsent);
  EXPECT_EQ(readings.foot_force_source[0], Source::kAbsent);
  EXPECT_EQ(readings.imu_source, Source::kMeasured);
  EXPECT_EQ(readings.motion_source, Source::kMeasured);
  EXPECT_EQ(readings.acceleration_m_s2[2], 9.81);
  EXPECT_TRUE(readings.device_error.empty());
}

TEST(LoopbackDriver, MovesOnlyWithItsMotorsOn) {
  const auto driver = opened({});
  driver->write(all_at(0.5));
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_NEAR(driver->read().position_rad.value[kTl0], 0, 1e-12);
  driver->activate(all_at(0));
  driver->write(all_at(0.5));
  EXPECT_NEAR(read_until(*driver, at(kTl0, 0.5)).position_rad.value[kTl0], 0.5, 1e-9);
  EXPECT_TRUE(driver->release());
  driver->write(all_at(-0.5));
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_NEAR(driver->read().position_rad.value[kTl0], 0.5, 1e-9);
}

TEST(LoopbackDriver, EndsAtTheServosTravel) {
  const auto driver = opened({});
  driver->activate(all_at(0));
  driver->write(all_at(9));
  // servo = 0.1 - joint >= -2
  EXPECT_NEAR(read_until(*driver, at(kTl0, 2.1)).position_rad.value[kTl0], 2.1, 1e-9);
}

TEST(LoopbackDriver, AWrongCalibrationShowsInItsReadings) {
  Config config;
  config.mounting["TL0"] = {0.4, 1};
  config.pose_rad["TL0"] = 0.2;
  const auto driver = opened(config);
  // The servo stands at 0.6; the calibration takes that for (0.6 - 0.1) * -1.
  EXPECT_NEAR(driver->read().position_rad.value[kTl0], -0.5, 1e-12);
}

TEST(LoopbackDriver, IsLostAsConfigured) {
  Config config;
  config.faults = {{FaultKind::kLost, {}}};
  const auto driver = opened(config);
  EXPECT_NO_THROW((void)driver->read());
  driver->activate(all_at(0));
  EXPECT_THROW((void)driver->read(), DeviceError);
  EXPECT_THROW(driver->write(all_at(0)), DeviceError);
  EXPECT_FALSE(driver->hold());
  driver->close();
  EXPECT_THROW(driver->open(), DeviceError);
}

TEST(LoopbackDriver, ComesBackAsConfigured) {
  Config config;
  config.faults = {{FaultKind::kLost, {}, 0, 0, 0.03}};
  const auto driver = opened(config);
  driver->activate(all_at(0));
  driver->close();
  bool open = false;
  for (int attempt = 0; attempt < 500 && !open; ++attempt) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    try {
      driver->open();
      open = true;
    } catch (const DeviceError&) {
      continue;
    }
  }
  EXPECT_TRUE(open);
}

TEST(LoopbackDriver, AppearsWhenConfigured) {
  Config config;
  config.appears_after_s = 1000;
  const auto driver = make(config, fast_robot(), calibration(), "");
  EXPECT_THROW(driver->open(), DeviceError);
}

TEST(LoopbackDriver, ShowsEachFault) {
  Config config;
  config.faults = {{FaultKind::kHot, "FL2", 90}, {FaultKind::kCurrent, "TL0", 7},
                   {FaultKind::kSupply, {}, 21}, {FaultKind::kTilt, {}, 1.1},
                   {FaultKind::kError, "TL0"},   {FaultKind::kStuck, "TL0"},
                   {FaultKind::kDeaf, {}}};
  const auto driver = opened(config);
  EXPECT_EQ(driver->read().pitch_rad, 0) << "motors were not on yet";
  driver->activate(all_at(0));
  driver->write(all_at(0.5));
  const Readings readings = read_until(*driver, at(kFl2, 0.5));
  EXPECT_EQ(readings.temperature_c[kFl2], 90);
  EXPECT_EQ(readings.temperature_c[kTl0], 25);
  EXPECT_EQ(readings.current_a[kTl0], 7);
  EXPECT_EQ(readings.supply_current_a, 21);
  EXPECT_EQ(readings.pitch_rad, 1.1);
  EXPECT_THAT(readings.device_error, HasSubstr("TL0"));
  EXPECT_NEAR(readings.position_rad.value[kTl0], 0, 1e-12);
  EXPECT_FALSE(driver->hold());
  EXPECT_FALSE(driver->release());
}

TEST(LoopbackDriver, NamesAJointWithoutACalibration) {
  try {
    (void)make({}, fast_robot(), {}, "");
    FAIL() << "made";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("TL0"));
  }
}

}  // namespace
}  // namespace scarab::bridge::loopback
