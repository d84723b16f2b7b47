#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "tests/unit/robot_bridge/dynamixel/driver_rig.hpp"

namespace scarab::bridge::dynamixel {
namespace {

using ::testing::HasSubstr;
using Clock = std::chrono::steady_clock;

constexpr double kRadPerTick = 2 * M_PI / 4096;
constexpr double kTorquePerCurrent = 4.1 / 2.3;

/// Every quantity another one in every servo.
std::map<std::uint8_t, ScriptedDevice> moving_devices() {
  auto devices = DriverRig::devices();
  for (auto& [id, device] : devices) {
    device.set(126, 2, 100 * id - 250);
    device.set(128, 4, 10 * id - 25);
    device.set(132, 4, 2048 + 100 * id);
    device.set(146, 1, 30 + id);
  }
  return devices;
}

TEST(DynamixelRead, MeasuresThroughTheCalibration) {
  for (const SyncReadKind kind : {SyncReadKind::kPlain, SyncReadKind::kFast}) {
    ScriptedBus bus(moving_devices());
    DriverRig rig;
    rig.config.sync_read = kind;
    const auto driver = rig.make_driver(bus);
    driver->open();
    const Readings r = driver->read();
    EXPECT_NEAR(r.position_rad.value[0], 100 * kRadPerTick, 1e-12);
    EXPECT_NEAR(r.position_rad.value[1], -200 * kRadPerTick, 1e-12);  // runs the other way
    EXPECT_NEAR(r.position_rad.value[2], 300 * kRadPerTick - M_PI / 2, 1e-12);
    EXPECT_NEAR(r.velocity_rad_s.value[0], -15 * 0.229 * M_PI / 30, 1e-12);
    EXPECT_NEAR(r.velocity_rad_s.value[1], 5 * 0.229 * M_PI / 30, 1e-12);
    EXPECT_NEAR(r.current_a[0], -0.4035, 1e-12);
    EXPECT_NEAR(r.torque_nm.value[0], -0.4035 * kTorquePerCurrent, 1e-12);
    EXPECT_NEAR(r.torque_nm.value[1], 0.1345 * kTorquePerCurrent, 1e-12);
    EXPECT_NEAR(r.supply_current_a, (150 + 50 + 50) * 2.69e-3, 1e-12);
    EXPECT_EQ(r.supply_current_source, Source::kMeasured);
    EXPECT_EQ(r.position_rad.source[2], Source::kMeasured);
    EXPECT_EQ(r.position_rad.source[3], Source::kAbsent);
    EXPECT_EQ(r.imu_source, Source::kAbsent);
    EXPECT_EQ(r.motion_source, Source::kAbsent);
    EXPECT_EQ(r.device_error, "");
  }
}

TEST(DynamixelRead, OneInstructionForAllServosAndOneForTheirHealth) {
  ScriptedBus bus(moving_devices());
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  bus.forget_heard();
  driver->read();
  const std::vector<Packet> heard = bus.heard();
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[0], fast_sync_read({126, 10}, {1, 2, 3}));
  EXPECT_EQ(heard[1], read(1, {146, 1}));
}

TEST(DynamixelRead, TemperaturesComeInTurn) {
  ScriptedBus bus(moving_devices());
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  Readings r = driver->read();
  EXPECT_EQ(r.temperature_c[0], 31);
  EXPECT_TRUE(std::isnan(r.temperature_c[1]));
  for (int i = 0; i < 5; ++i) r = driver->read();
  EXPECT_EQ(r.temperature_c[1], 32);
  EXPECT_EQ(r.temperature_c[2], 33);
  EXPECT_TRUE(std::isnan(r.temperature_c[3]));
}

TEST(DynamixelRead, ABrokenAnswerIsAskedForAgainAndCounted) {
  for (const SyncReadKind kind : {SyncReadKind::kPlain, SyncReadKind::kFast}) {
    ScriptedBus bus(moving_devices());
    DriverRig rig;
    rig.config.sync_read = kind;
    const auto driver = rig.make_driver(bus);
    driver->open();
    int left = 1;
    bus.script([&left](const Packet& instruction, Bytes answer) {
      if (as_sync_read(instruction) && left-- > 0) answer[answer.size() / 2] ^= 0x04;
      return answer;
    });
    EXPECT_NEAR(driver->read().position_rad.value[0], 100 * kRadPerTick, 1e-12);
    EXPECT_EQ(counter(*driver, "bus_retries"), 1U);
    EXPECT_EQ(counter(*driver, "bus_crc_errors"), 1U);
  }
}

TEST(DynamixelRead, ASilentServoIsNamedWithinTheBound) {
  for (const SyncReadKind kind : {SyncReadKind::kPlain, SyncReadKind::kFast}) {
    ScriptedBus bus(moving_devices());
    DriverRig rig;
    rig.config.sync_read = kind;
    const auto driver = rig.make_driver(bus);
    driver->open();
    bus.change(2, [](ScriptedDevice& device) { device.silent = true; });
    const Clock::time_point begun = Clock::now();
    EXPECT_EQ(device_error([&] { driver->read(); }),
              bus.path() + ": joint TL1 (ID 2) does not answer (attempts: 3)");
    const auto taken = Clock::now() - begun;
    EXPECT_GE(taken, std::chrono::milliseconds(150));  // each attempt has its time
    EXPECT_LT(taken, std::chrono::milliseconds(300));
    EXPECT_EQ(counter(*driver, "bus_timeouts"), 3U);

    bus.change(2, [](ScriptedDevice& device) { device.silent = false; });
    EXPECT_NO_THROW(driver->read());  // once it answers again, all is well
  }
}

TEST(DynamixelRead, LostPowerAndALineOfNoiseHaveOtherSentences) {
  for (const SyncReadKind kind : {SyncReadKind::kPlain, SyncReadKind::kFast}) {
    ScriptedBus bus(moving_devices());
    DriverRig rig;
    rig.config.sync_read = kind;
    rig.config.reply_timeout_s = 0.02;
    const auto driver = rig.make_driver(bus);
    driver->open();
    bus.script([](const Packet&, const Bytes&) { return Bytes{}; });
    EXPECT_EQ(device_error([&] { driver->read(); }),
              bus.path() + ": nobody answers, first asked was joint TL0 (ID 1) (attempts: 3)");
    bus.script([](const Packet&, Bytes answer) {
      if (answer.size() > 12) answer[12] ^= 0xFF;
      return answer;
    });
    EXPECT_EQ(device_error([&] { driver->read(); }),
              bus.path() + ": answers arrive broken, first that of joint TL0 (ID 1) (attempts: 3)");
  }
}

TEST(DynamixelRead, AnAlertIsNamedWithItsJoint) {
  ScriptedBus bus(moving_devices());
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  EXPECT_EQ(driver->read().device_error, "");
  bus.change(2, [](ScriptedDevice& device) { device.set(70, 1, 0x24); });
  EXPECT_EQ(driver->read().device_error, "joint TL1: overheating, overload");
  bus.change(3, [](ScriptedDevice& device) { device.set(70, 1, 0x01); });
  EXPECT_EQ(driver->read().device_error,
            "joint TL1: overheating, overload; joint TL2: input voltage");
  bus.change(2, [](ScriptedDevice& device) { device.set(70, 1, 0); });
  EXPECT_EQ(driver->read().device_error, "joint TL2: input voltage");
}

TEST(DynamixelRead, AServoAtItsOwnTemperatureLimitIsAnError) {
  auto devices = DriverRig::devices();
  devices[1].set(31, 1, 70);
  devices[1].set(146, 1, 70);
  ScriptedBus bus(devices);
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  EXPECT_EQ(driver->read().device_error, "joint TL0: 70 C, its own limit is 70 C");
}

TEST(DynamixelRead, BoardsOnTheBus) {
  auto devices = DriverRig::devices();
  ScriptedDevice imu;
  imu.set(20, 2, -120);        // roll, mrad
  imu.set(22, 2, 340);         // pitch
  imu.set(30, 4, 0x3FC00000);  // 1.5 as a float
  imu.set(40, 2, 981);
  devices[100] = imu;
  ScriptedDevice feet;
  for (std::size_t leg = 0; leg < 6; ++leg) feet.set(10 + 2 * leg, 2, static_cast<int>(leg) * 10);
  devices[101] = feet;
  ScriptedBus bus(devices);
  DriverRig rig;
  rig.config.imu =
      ImuConfig{100,
                {20, Type::kI16, 1e-3},
                {22, Type::kI16, 1e-3},
                {{{26, Type::kF32, 1}, {30, Type::kF32, 1}, {34, Type::kF32, 1}}},
                {{{38, Type::kI16, 0.01}, {40, Type::kI16, 0.01}, {42, Type::kI16, 0.01}}}};
  rig.config.foot_force.emplace();
  rig.config.foot_force->id = 101;
  for (std::size_t leg = 0; leg < 6; ++leg) {
    rig.config.foot_force->force[leg] = {static_cast<std::uint16_t>(10 + 2 * leg), Type::kU16, 0.5};
  }
  const auto driver = rig.make_driver(bus);
  driver->open();
  const Readings r = driver->read();
  EXPECT_EQ(r.imu_source, Source::kMeasured);
  EXPECT_EQ(r.motion_source, Source::kMeasured);
  EXPECT_NEAR(r.roll_rad, -0.12, 1e-12);
  EXPECT_NEAR(r.pitch_rad, 0.34, 1e-12);
  EXPECT_DOUBLE_EQ(r.angular_velocity_rad_s[1], 1.5);
  EXPECT_NEAR(r.acceleration_m_s2[1], 9.81, 1e-12);
  EXPECT_DOUBLE_EQ(r.foot_force_n[3], 15);
  EXPECT_EQ(r.foot_force_source[5], Source::kMeasured);
  EXPECT_TRUE(driver->capabilities().imu);
  EXPECT_TRUE(driver->capabilities().foot_force);
}

TEST(DynamixelRead, SurvivesAnUnpluggedPortAndOpensItAgain) {
  const std::filesystem::path link =
      std::filesystem::path(::testing::TempDir()) / ("dynamixel-" + std::to_string(::getpid()));
  std::filesystem::remove(link);
  DriverRig rig;
  auto first = std::make_unique<ScriptedBus>(DriverRig::devices());
  std::filesystem::create_symlink(first->path(), link);
  const auto driver = make(rig.config, rig.robot, rig.calibration, link.string());
  driver->open();
  driver->activate({});
  first->unplug();
  EXPECT_THAT(device_error([&] { driver->read(); }), HasSubstr(link.string()));
  EXPECT_FALSE(driver->hold());
  EXPECT_FALSE(driver->release());
  driver->close();
  EXPECT_FALSE(device_error([&] { driver->open(); }).empty());

  const ScriptedBus second(DriverRig::devices());
  std::filesystem::remove(link);
  std::filesystem::create_symlink(second.path(), link);
  driver->open();
  EXPECT_EQ(driver->read().position_rad.source[0], Source::kMeasured);
  std::filesystem::remove(link);
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
