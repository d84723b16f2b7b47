#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <thread>

#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "tests/unit/robot_bridge/dynamixel/driver_rig.hpp"

namespace scarab::bridge::dynamixel {
namespace {

using ::testing::HasSubstr;

constexpr double kRadPerTick = 2 * M_PI / 4096;
constexpr std::uint8_t kIds[] = {1, 2, 3};

/// Where the rig's servos stand, as joints.
robot::JointVector standing() {
  robot::JointVector rad{};
  rad[2] = -M_PI / 2;
  return rad;
}

struct Powered {
  explicit Powered(const DriverRig& rig = DriverRig()) : driver(rig.make_driver(bus)) {
    driver->open();
    driver->activate(standing());
  }
  ScriptedBus bus{DriverRig::devices()};
  std::unique_ptr<Driver> driver;
};

/// The addresses of the sync writes that a bus has heard, in order.
std::vector<int> written(ScriptedBus& bus) {
  std::vector<int> addresses;
  for (const Packet& packet : bus.heard()) {
    if (const auto write = as_sync_write(packet)) addresses.push_back(write->region.address);
  }
  return addresses;
}

TEST(DynamixelActivate, GoalsThenWatchdogThenTorque) {
  DriverRig rig;
  rig.config.bus_watchdog_s = 0.25;  // 13 times 20 ms, rounded up
  auto devices = DriverRig::devices();
  devices[2].set(98, 1, -1);  // tripped before
  ScriptedBus bus(devices);
  const auto driver = rig.make_driver(bus);
  driver->open();
  bus.forget_heard();
  driver->activate(standing());
  EXPECT_EQ(written(bus), (std::vector<int>{98, 116, 98, 64}));
  for (const std::uint8_t id : kIds) {
    EXPECT_EQ(bus.device(id).get(116, 4), 2048);
    EXPECT_EQ(bus.device(id).get(98, 1), 13);
    EXPECT_EQ(bus.device(id).get(64, 1), 1);
  }
  EXPECT_NEAR(*driver->capabilities().device_timeout_s, 0.26, 1e-12);
}

TEST(DynamixelActivate, ALostWriteIsWrittenAgain) {
  ScriptedBus bus(DriverRig::devices());
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  bus.change(3, [](ScriptedDevice& device) { device.lost_writes = 2; });  // watchdog and goal
  robot::JointVector hold = standing();
  hold[2] += 60 * kRadPerTick;
  driver->activate(hold);
  EXPECT_EQ(bus.device(3).get(116, 4), 2108);
}

TEST(DynamixelActivate, WhatWasSwitchedOnIsSwitchedOffWhenOneRefuses) {
  ScriptedBus bus(DriverRig::devices());
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  bus.change(3, [](ScriptedDevice& device) { device.set(70, 1, 0x20); });
  bus.forget_heard();
  EXPECT_EQ(device_error([&] { driver->activate(standing()); }),
            bus.path() + ": joint TL2 (ID 3) does not take torque 1, it has 0 (overload)");
  for (const std::uint8_t id : kIds) EXPECT_EQ(bus.device(id).get(64, 1), 0);
  const std::vector<int> addresses = written(bus);
  EXPECT_EQ(std::count(addresses.begin(), addresses.end(), 64), 4);  // three times on, then off
  EXPECT_TRUE(driver->release());
}

TEST(DynamixelActivate, AJointBeyondItsRangeIsNotThrownBack) {
  auto devices = DriverRig::devices();
  devices[1].set(132, 4, 3900);  // calibrated up to 3352
  ScriptedBus bus(devices);
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  robot::JointVector hold = standing();
  hold[0] = driver->read().position_rad.value[0];
  EXPECT_THAT(device_error([&] { driver->activate(hold); }),
              HasSubstr("joint TL0 (ID 1) stands at 2.84 rad, 0.84 rad beyond its range"));
  EXPECT_EQ(bus.device(1).get(64, 1), 0);
}

TEST(DynamixelActivate, NeedsAnOpenBus) {
  const ScriptedBus bus(DriverRig::devices());
  const auto driver = DriverRig().make_driver(bus);
  EXPECT_THAT(device_error([&] { driver->activate({}); }), HasSubstr("is not open"));
  EXPECT_THAT(device_error([&] { driver->write({}); }), HasSubstr("motors that are off"));
}

TEST(DynamixelWrite, GoesThroughTheCalibrationInOneInstruction) {
  Powered robot;
  robot.bus.forget_heard();
  robot::JointVector target = standing();
  target[0] = 100 * kRadPerTick;
  target[1] = 100 * kRadPerTick;
  target[2] += 100 * kRadPerTick;
  robot.driver->write(target);
  robot.driver->read();  // comes behind it on the line
  EXPECT_EQ(
      robot.bus.heard().front(),
      sync_write(
          {{116, 4}, {{1, {0x64, 0x08, 0, 0}}, {2, {0x9C, 0x07, 0, 0}}, {3, {0x64, 0x08, 0, 0}}}}));
  EXPECT_EQ(counter(*robot.driver, "goals_limited"), 0U);
}

TEST(DynamixelWrite, NoGoalLiesOutsideOfWhatTheServoTakes) {
  auto devices = DriverRig::devices();
  devices[1].set(48, 4, 2500);  // less than its calibration
  ScriptedBus bus(devices);
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  driver->activate(standing());
  robot::JointVector target = standing();
  target[0] = 1.9;  // 3287, calibrated
  target[1] = 3.0;  // the servo's -3.0, calibrated down to -2: 744
  driver->write(target);
  driver->read();
  EXPECT_EQ(bus.device(1).get(116, 4), 2500);
  EXPECT_EQ(bus.device(2).get(116, 4), 744);
  EXPECT_EQ(counter(*driver, "goals_limited"), 1U);  // the other was ended by the calibration
}

TEST(DynamixelHold, StopsWhoLagsAndLeavesTheOthersTheirGoals) {
  Powered robot;
  robot::JointVector target = standing();
  target[0] = 0.04;
  target[1] = -0.5;
  robot.driver->write(target);
  robot.bus.change(1, [](ScriptedDevice& device) { device.set(132, 4, 2050); });
  robot.bus.change(2, [](ScriptedDevice& device) { device.set(132, 4, 2100); });
  robot.driver->read();
  robot.bus.forget_heard();
  EXPECT_TRUE(robot.driver->hold());
  EXPECT_EQ(robot.bus.device(1).get(116, 4), 2048 + std::lround(0.04 / kRadPerTick));
  EXPECT_EQ(robot.bus.device(2).get(116, 4), 2100);
  EXPECT_TRUE(as_sync_write(robot.bus.heard().front()));  // at once, before anything is asked
  EXPECT_EQ(robot.bus.device(1).get(64, 1), 1);
}

TEST(DynamixelHold, SaysWhenTheServosDoNotConfirm) {
  DriverRig rig;
  rig.config.reply_timeout_s = 0.01;
  Powered robot(rig);
  robot.bus.change(2, [](ScriptedDevice& device) { device.silent = true; });
  EXPECT_FALSE(robot.driver->hold());
}

TEST(DynamixelRelease, TakesTheTorqueAway) {
  Powered robot;
  EXPECT_TRUE(robot.driver->release());
  for (const std::uint8_t id : kIds) {
    EXPECT_EQ(robot.bus.device(id).get(64, 1), 0);
    EXPECT_EQ(robot.bus.device(id).get(98, 1), 0);
  }
  EXPECT_TRUE(robot.driver->hold());  // nothing moves
}

TEST(DynamixelRelease, ReachesTheOthersWhenOneIsSilent) {
  DriverRig rig;
  rig.config.reply_timeout_s = 0.01;
  Powered robot(rig);
  robot.bus.change(1, [](ScriptedDevice& device) { device.silent = true; });
  EXPECT_FALSE(robot.driver->release());
  EXPECT_EQ(robot.bus.device(2).get(64, 1), 0);
  EXPECT_EQ(robot.bus.device(3).get(64, 1), 0);
}

/// A robot that holds is not to fall because one of its servos is lost.
TEST(DynamixelHold, IsNotTakenBackByClosingTheLine) {
  Powered robot;
  EXPECT_TRUE(robot.driver->hold());
  robot.driver->close();
  for (const std::uint8_t id : kIds) {
    EXPECT_EQ(robot.bus.device(id).get(64, 1), 1);
    EXPECT_NE(robot.bus.device(id).get(98, 1), 0) << "its time-out stands";
  }
}

TEST(DynamixelRelease, ComesWithTheEndOfTheDriver) {
  Powered robot;
  robot.driver.reset();
  for (const std::uint8_t id : kIds) EXPECT_EQ(robot.bus.device(id).get(64, 1), 0);
}

TEST(DynamixelCrash, TheFrameAloneSwitchesTheMotorsOff) {
  Powered robot;
  const auto frame = robot.driver->crash_frame();
  ASSERT_TRUE(frame);
  ASSERT_EQ(::write(frame->fd, frame->bytes.data(), frame->bytes.size()),
            static_cast<ssize_t>(frame->bytes.size()));
  robot.driver->read();  // comes behind it on the line
  for (const std::uint8_t id : kIds) EXPECT_EQ(robot.bus.device(id).get(64, 1), 0);
}

TEST(DynamixelWatchdog, ATrippedOneIsNoticedAfterASilence) {
  DriverRig rig;
  rig.config.bus_watchdog_s = 0.02;
  Powered robot(rig);
  robot.bus.change(2, [](ScriptedDevice& device) { device.set(98, 1, -1); });
  std::this_thread::sleep_for(std::chrono::milliseconds(25));  // the silence itself
  EXPECT_THAT(device_error([&] { robot.driver->write(standing()); }),
              HasSubstr("the bus watchdog of joint TL1 (ID 2) has stopped it"));
  EXPECT_TRUE(robot.driver->release());
  EXPECT_NO_THROW(robot.driver->activate(standing()));
}

TEST(DynamixelHealth, ALostTorqueIsAnError) {  // a servo whose power was away for a moment
  Powered robot;
  robot.bus.change(3, [](ScriptedDevice& device) { device.set(64, 1, 0); });
  Readings readings;
  for (int i = 0; i < 6; ++i) readings = robot.driver->read();
  EXPECT_EQ(readings.device_error, "joint TL2: has lost its torque (was its power away?)");
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
