#include <gmock/gmock.h>

#include <chrono>
#include <numeric>
#include <stdexcept>

#include "services/robot_bridge/drivers/amosii/config.hpp"
#include "tests/unit/robot_bridge/amosii/fake_board.hpp"

namespace scarab::bridge::amosii {
namespace {

using Clock = std::chrono::steady_clock;
using test::Bytes;
using testing::ElementsAreArray;
using testing::HasSubstr;

constexpr std::size_t kSetSize = 34;
constexpr std::size_t kTl0 = 0;
constexpr std::size_t kCl0 = 6;

test::Bytes silent(const Bytes& /*reply*/) { return {}; }

test::Bytes without_terminator(Bytes reply) {
  reply.back() = 9;
  return reply;
}

test::Bytes one_lost(Bytes reply) {
  reply.erase(reply.begin() + 7);
  return reply;
}

test::Bytes cut_off(Bytes reply) {
  reply.resize(20);
  return reply;
}

/// Less than what the kernel keeps for a reader, so that the board does not wait for one.
test::Bytes flood(const Bytes& /*reply*/) { return Bytes(1000, 7); }

test::Bytes behind_garbage(Bytes reply) {
  reply.insert(reply.begin(), {5, 0, 1});
  return reply;
}

Config config() {
  Config result;
  result.port = "/dev/ttyNotThere0";
  result.reply_timeout_s = 0.5;
  result.attempts = 3;
  result.pause_s = 0;
  result.foot_full_scale_n = 20;
  result.inclinometer = Inclinometer{{128, 0.01}, {100, -0.02}};
  result.motor_current = {128, 0.5};
  return result;
}

/// Every joint turns by +-1 rad, the thoraco-coxal and coxa-trochanteral ones against the servos.
Calibration calibration() {
  Calibration result;
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    result.joints[joint] = JointCalibration{0, joint < 12 ? -1 : 1, -1, 1};
  }
  return result;
}

std::unique_ptr<Driver> driver_of(const std::string& device, const Config& with = config()) {
  return make(with, robot::RobotModel{}, calibration(), device);
}

robot::JointVector all_at(double rad) {
  robot::JointVector angles{};
  angles.fill(rad);
  return angles;
}

std::uint64_t counter(const Driver& driver, const std::string& name) {
  for (const auto& entry : driver.counters()) {
    if (entry.first == name) return entry.second;
  }
  throw std::out_of_range(name);
}

TEST(AmosiiDriver, ReadsWhatTheBoardMeasures) {
  FakeBoard board;
  Slots sensors = all_slots(1);
  sensors[14] = 70;   // L0, halfway between 40 and 100
  sensors[9] = 200;   // R2, beyond 110
  sensors[8] = 158;   // inclinometer x
  sensors[7] = 110;   // inclinometer y
  sensors[29] = 134;  // motor current
  board.sense(sensors);
  const auto driver = driver_of(board.path());
  driver->open();
  const Readings readings = driver->read();
  EXPECT_NEAR(readings.foot_force_n[0], 10, 1e-12);
  EXPECT_NEAR(readings.foot_force_n[5], 20, 1e-12);
  EXPECT_EQ(readings.foot_force_n[1], 0);
  EXPECT_EQ(readings.foot_force_source[1], Source::kMeasured);
  EXPECT_NEAR(readings.roll_rad, 0.30, 1e-12);
  EXPECT_NEAR(readings.pitch_rad, -0.20, 1e-12);
  EXPECT_EQ(readings.imu_source, Source::kMeasured);
  EXPECT_EQ(readings.motion_source, Source::kAbsent)
      << "it has neither gyroscope nor accelerometer";
  EXPECT_NEAR(readings.supply_current_a, 3, 1e-12);
  EXPECT_EQ(readings.supply_current_source, Source::kMeasured);
  EXPECT_EQ(readings.velocity_rad_s.source[kTl0], Source::kAbsent);
  EXPECT_EQ(readings.torque_nm.source[kTl0], Source::kAbsent);
}

TEST(AmosiiDriver, HasNoInclinationWithoutAnInclinometer) {
  FakeBoard board;
  Config without = config();
  without.inclinometer.reset();
  const auto driver = driver_of(board.path(), without);
  driver->open();
  EXPECT_EQ(driver->read().imu_source, Source::kAbsent);
  EXPECT_FALSE(driver->capabilities().imu);
}

TEST(AmosiiDriver, PositionsAreThoseCommandedAndUnknownBefore) {
  FakeBoard board;
  const auto driver = driver_of(board.path());
  driver->open();
  EXPECT_EQ(driver->read().position_rad.source[kTl0], Source::kAbsent);
  driver->activate(all_at(0.25));
  EXPECT_NEAR(driver->read().position_rad.value[kTl0], 0.25, 1e-12);
  driver->write(all_at(3));
  const Readings readings = driver->read();
  EXPECT_NEAR(readings.position_rad.value[kTl0], 1, 1e-12) << "the end of the servo's travel";
  EXPECT_NEAR(readings.position_rad.value[kCl0], 0.9, 1e-12) << "what its trim leaves of it";
  EXPECT_EQ(readings.position_rad.source[kTl0], Source::kCommanded);
}

TEST(AmosiiDriver, WritesTheBytesOfTheTable) {
  FakeBoard board;
  const auto driver = driver_of(board.path());
  driver->open();
  (void)board.take_received(2);
  driver->write(all_at(0.5));
  // By hand as in frames_test.cpp: m = -.5 for T and C (C less .1: -.6), .5 for F and the backbone.
  // TL .25 * 234 + 9 = 67.5, TR .25 * -237 + 243 = 183.75, C .2 * 244 + 6 = 54.8 or .2 * -244 + 250
  // = 201.2, FL 202.5, 51.75, 51.75, FR .75 * (-170, 180, 183) + (180, 61, 60) = 52.5, 196, 197.25,
  // BJ .75 * -249 + 250 = 63.25.
  const std::vector<int> expected = {1,   63,  128, 128, 128, 128, 128, 128, 128, 54, 51,  67,
                                     183, 201, 197, 128, 128, 128, 128, 201, 202, 67, 183, 54,
                                     52,  196, 183, 51,  54,  67,  201, 128, 128, 0};
  EXPECT_THAT(board.take_received(kSetSize), ElementsAreArray(expected));
}

TEST(AmosiiDriver, AsksAgainWhenAReplyIsDamaged) {
  FakeBoard board;
  const auto driver = driver_of(board.path());
  driver->open();
  board.go_wrong({without_terminator, one_lost});
  EXPECT_NO_THROW((void)driver->read());
  EXPECT_EQ(counter(*driver, "amosii_replies_damaged"), 2U);
  EXPECT_EQ(counter(*driver, "amosii_gets"), 4U);
  EXPECT_EQ(counter(*driver, "amosii_replies"), 2U);
}

TEST(AmosiiDriver, AsksAgainWhenAReplyIsLate) {
  FakeBoard board;
  Config hasty = config();
  hasty.reply_timeout_s = 0.05;
  hasty.attempts = 10;
  const auto driver = driver_of(board.path(), hasty);
  driver->open();
  board.go_wrong({silent, cut_off});
  EXPECT_NO_THROW((void)driver->read());
  EXPECT_GE(counter(*driver, "amosii_replies_missing"), 2U);
}

TEST(AmosiiDriver, FindsAReplyBehindGarbage) {
  FakeBoard board;
  Slots sensors = all_slots(kMiddle);
  sensors[29] = 130;
  board.sense(sensors);
  const auto driver = driver_of(board.path());
  driver->open();
  board.go_wrong({behind_garbage});
  EXPECT_NEAR(driver->read().supply_current_a, 1, 1e-12);
  EXPECT_EQ(counter(*driver, "amosii_gets"), 2U) << "not asked again";
}

TEST(AmosiiDriver, GivesUpABoardThatIsSilent) {
  FakeBoard board;
  Config hasty = config();
  hasty.reply_timeout_s = 0.02;
  const auto driver = driver_of(board.path(), hasty);
  board.go_wrong({silent, silent, silent});
  const auto begin = Clock::now();
  try {
    driver->open();
    FAIL() << "opened";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), HasSubstr(board.path() + ": the board has not answered"));
  }
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(60));
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(3));
  EXPECT_THROW((void)driver->read(), DeviceError) << "it is closed again";
}

TEST(AmosiiDriver, IsNotKeptByALineThatNeverFallsSilent) {
  FakeBoard board;
  const auto driver = driver_of(board.path());
  driver->open();
  board.go_wrong({flood, flood, flood});
  const auto begin = Clock::now();
  EXPECT_THROW((void)driver->read(), DeviceError);
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(5));
  EXPECT_EQ(counter(*driver, "amosii_replies_damaged"), 3U);
}

TEST(AmosiiDriver, SaysThatItIsUnplugged) {
  FakeBoard board;
  const auto driver = driver_of(board.path());
  driver->open();
  board.unplug();
  EXPECT_THROW((void)driver->read(), DeviceError);
  EXPECT_THROW(driver->write(all_at(0)), DeviceError);
}

TEST(AmosiiDriver, HoldsOfItselfAndCannotRelease) {
  FakeBoard board;
  const auto driver = driver_of(board.path());
  EXPECT_FALSE(driver->hold());
  driver->open();
  driver->activate(all_at(0));
  (void)board.take_received(2 + kSetSize);
  EXPECT_TRUE(driver->hold());
  EXPECT_FALSE(driver->release());
  (void)driver->read();
  EXPECT_THAT(board.take_received(2), testing::ElementsAre(2, 0)) << "no set in between";
  EXPECT_FALSE(driver->crash_frame().has_value());
  const Capabilities able = driver->capabilities();
  EXPECT_FALSE(able.position_feedback);
  EXPECT_FALSE(able.torque_switch);
  EXPECT_FALSE(able.device_timeout_s.has_value());
  EXPECT_EQ(able.link, board.path() + " at 57600 baud");
}

TEST(AmosiiDriver, KeepsSilenceAroundASet) {
  FakeBoard board;
  Config slow = config();
  slow.pause_s = 0.03;
  const auto driver = driver_of(board.path(), slow);
  driver->open();
  const auto begin = Clock::now();
  driver->write(all_at(0));
  (void)driver->read();
  EXPECT_GE(Clock::now() - begin, std::chrono::milliseconds(60));
}

TEST(AmosiiDriver, NamesAJointWithoutACalibration) {
  Calibration some = calibration();
  some.joints[7].reset();
  try {
    (void)make(config(), robot::RobotModel{}, some, "");
    FAIL() << "made";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("CL1"));
  }
  robot::RobotModel without;
  without.joints[7].present = false;
  EXPECT_NO_THROW((void)make(config(), without, some, ""));
}

}  // namespace
}  // namespace scarab::bridge::amosii
