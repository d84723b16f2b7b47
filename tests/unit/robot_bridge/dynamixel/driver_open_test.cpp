#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/serial/serial_error.hpp"
#include "tests/unit/robot_bridge/dynamixel/driver_rig.hpp"

namespace scarab::bridge::dynamixel {
namespace {

using ::testing::HasSubstr;

int writes_to(const std::vector<Packet>& heard, std::uint16_t address) {
  int writes = 0;
  for (const Packet& packet : heard) {
    const auto write = as_write(packet);
    const auto sync = as_sync_write(packet);
    if ((write && write->address == address) || (sync && sync->region.address == address)) ++writes;
  }
  return writes;
}

TEST(DynamixelOpen, FindsAndPreparesEveryServo) {
  auto devices = DriverRig::devices();
  devices[2].set(64, 1, 1);   // left on by somebody else
  devices[3].set(11, 1, 16);  // PWM control
  ScriptedBus bus(devices);
  const auto driver = DriverRig().make_driver(bus);
  driver->open();
  for (const std::uint8_t id : {std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{3}}) {
    EXPECT_EQ(bus.device(id).get(64, 1), 0) << "torque";
    EXPECT_EQ(bus.device(id).get(9, 1), 0) << "return delay";
    EXPECT_EQ(bus.device(id).get(11, 1), 3) << "operating mode";
  }
  EXPECT_EQ(writes_to(bus.heard(), 11), 1);  // only where it was another

  bus.forget_heard();
  driver->open();
  EXPECT_EQ(writes_to(bus.heard(), 9) + writes_to(bus.heard(), 11), 0);  // EEPROM wears out
  EXPECT_EQ(counter(*driver, "device_opened"), 2U);
}

TEST(DynamixelOpen, NamesAllThatAreMissing) {
  auto devices = DriverRig::devices();
  devices[1].silent = true;
  devices.erase(3);
  ScriptedBus bus(devices);
  DriverRig rig;
  rig.config.reply_timeout_s = 0.01;
  const auto driver = rig.make_driver(bus);
  EXPECT_EQ(device_error([&] { driver->open(); }),
            bus.path() + ": missing: joint TL0 (ID 1), joint TL2 (ID 3)");
  EXPECT_FALSE(driver->crash_frame());  // closed again
}

TEST(DynamixelOpen, NamesTheModelThatAnswersInstead) {
  auto devices = DriverRig::devices();
  devices[2].model_number = 1060;
  ScriptedBus bus(devices);
  const auto driver = DriverRig().make_driver(bus);
  EXPECT_EQ(device_error([&] { driver->open(); }),
            bus.path() + ": joint TL1 (ID 2) is a model 1060 in place of 1020");
}

TEST(DynamixelOpen, OneReasonForAllIsNotToldForEach) {
  auto devices = DriverRig::devices();
  for (auto& [id, device] : devices) device.model_number = 1120;
  devices[4] = devices[1];
  ScriptedBus bus(devices);
  DriverRig rig;
  rig.robot.joints[3].present = true;
  rig.config.servos["TR0"].id = 4;
  rig.calibration.joints[3] = rig.calibration.joints[0];
  EXPECT_THAT(device_error([&] { rig.make_driver(bus)->open(); }),
              HasSubstr("joint TL2 (ID 3) is a model 1120 in place of 1020 and 1 more"));
}

TEST(DynamixelOpen, AnOldFirmwareCannotBeReadTogether) {
  auto devices = DriverRig::devices();
  devices[3].firmware = 44;
  ScriptedBus bus(devices);
  DriverRig rig;
  EXPECT_EQ(device_error([&] { rig.make_driver(bus)->open(); }),
            bus.path() +
                ": joint TL2 (ID 3) has firmware 44, fast sync reads need 45 (or "
                "`sync_read: plain`)");
  rig.config.sync_read = SyncReadKind::kPlain;
  EXPECT_NO_THROW(rig.make_driver(bus)->open());
}

TEST(DynamixelOpen, ASilentBusIsOneSentence) {
  ScriptedBus bus({});
  DriverRig rig;
  rig.config.reply_timeout_s = 0.005;
  const auto driver = rig.make_driver(bus);
  EXPECT_THAT(device_error([&] { driver->open(); }), HasSubstr("no device answers"));
}

TEST(DynamixelOpen, NamesAMissingBoard) {
  ScriptedBus bus(DriverRig::devices());
  DriverRig rig;
  rig.config.reply_timeout_s = 0.01;
  rig.config.imu.emplace();
  rig.config.imu->id = 100;
  const auto driver = rig.make_driver(bus);
  EXPECT_EQ(device_error([&] { driver->open(); }),
            bus.path() + ": missing: the IMU board (ID 100)");
}

TEST(DynamixelOpen, RefusesDriveModesThatChangeWhatGoalsMean) {
  for (const int mode : {0x01, 0x08}) {
    auto devices = DriverRig::devices();
    devices[3].set(10, 1, mode);
    ScriptedBus bus(devices);
    const auto driver = DriverRig().make_driver(bus);
    EXPECT_THAT(device_error([&] { driver->open(); }),
                HasSubstr("joint TL2 (ID 3) is in drive mode " + std::to_string(mode)));
  }
}

TEST(DynamixelOpen, RefusesACalibrationThatTheServoCannotReach) {
  auto devices = DriverRig::devices();
  devices[1].set(52, 4, 3500);  // its least goal; calibrated are 744 to 3352
  ScriptedBus bus(devices);
  const auto driver = DriverRig().make_driver(bus);
  EXPECT_THAT(device_error([&] { driver->open(); }),
              HasSubstr("joint TL0 (ID 1) takes goals from 3500 to 4095, its calibration means 744 "
                        "to 3352"));
}

TEST(DynamixelOpen, NoPortIsASerialError) {
  DriverRig rig;
  rig.config.port = "/dev/no-such-port";
  const auto driver = make(rig.config, rig.robot, rig.calibration, "");
  EXPECT_THROW(driver->open(), serial::SerialError);
}

TEST(DynamixelMake, NeedsAServoAndACalibrationForEveryJoint) {
  const auto refused = [](const DriverRig& rig) -> std::string {
    try {
      static_cast<void>(make(rig.config, rig.robot, rig.calibration, ""));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  DriverRig no_servo;
  no_servo.config.servos.erase("TL1");
  EXPECT_THAT(refused(no_servo), HasSubstr("TL1 of three joints has no servo"));
  DriverRig no_calibration;
  no_calibration.calibration.joints[2].reset();
  EXPECT_THAT(refused(no_calibration), HasSubstr("TL2 of three joints has no calibration"));
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
