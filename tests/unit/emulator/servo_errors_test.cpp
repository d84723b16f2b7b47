#include <gmock/gmock.h>

#include "tests/unit/emulator/dynamixel_rig.hpp"
#include "tests/unit/emulator/suffering.hpp"
#include "tools/emulator/boards/dynamixel/servo_table.hpp"

/// The error byte of a status (e-Manual, Protocol 2.0, "Error").
namespace scarab::emulator {
namespace {

using dxl::StatusError;
using testing::Bytes;
using testing::DynamixelRig;
using ::testing::ElementsAre;
using testing::hex;
using ::testing::IsEmpty;
using testing::suffering;

class ServoErrors : public ::testing::Test {
 protected:
  DynamixelRig rig;
};

TEST_F(ServoErrors, AWrongCrcIsAnswered) {
  // The manual's ping with another last byte; "error 3" of device 1.
  const Bytes answer = rig.say("FF FF FD 00 01 03 00 01 19 4F");
  ASSERT_EQ(answer.size(), 11U);
  EXPECT_EQ(Bytes(answer.begin(), answer.end() - 2), hex("FF FF FD 00 01 04 00 55 03"));
  EXPECT_THAT(rig.noted("frame_bad"), ElementsAre("to ID 1"));
  EXPECT_THAT(rig.say("FF FF FD 00 FE 03 00 01 31 43"), IsEmpty()) << "nobody answers for all";
}

TEST_F(ServoErrors, AnInstructionNobodyKnows) {
  EXPECT_EQ(rig.ask({1, 0x77, {}}).error, StatusError::kInstruction);
}

TEST_F(ServoErrors, WhatMayNotBeWritten) {
  EXPECT_EQ(rig.write(1, rig.model.present_position, 5), StatusError::kAccess);
  EXPECT_EQ(rig.write(1, {300, dxl::Type::kU8, 1}, 5), StatusError::kAccess);
  EXPECT_EQ(rig.write(1, rig.model.torque_enable, 2), StatusError::kDataRange);
  EXPECT_EQ(rig.write(1, {116, dxl::Type::kU16, 1}, 5), StatusError::kDataLength);
  EXPECT_EQ(rig.ask(dxl::read(1, {300, 4})).error, StatusError::kAccess);
}

TEST_F(ServoErrors, TheEepromIsClosedUnderTorque) {
  EXPECT_EQ(rig.write(1, rig.model.return_delay, 0), StatusError::kNone);
  EXPECT_EQ(rig.replies.front().delay_ns, 0);
  rig.write(1, rig.model.torque_enable, 1);
  EXPECT_EQ(rig.write(1, rig.model.return_delay, 5), StatusError::kAccess);
  EXPECT_EQ(rig.read(1, rig.model.return_delay), 0);
}

TEST_F(ServoErrors, GoalsBeyondTheLimitsAreRefused) {
  rig.write(1, rig.model.max_position_limit, 3000);
  rig.write(1, rig.model.min_position_limit, 1000);
  EXPECT_EQ(rig.write(1, rig.model.goal_position, 3001), StatusError::kDataLimit);
  EXPECT_EQ(rig.write(1, rig.model.goal_position, 999), StatusError::kDataLimit);
  EXPECT_EQ(rig.write(1, rig.model.goal_position, 5000), StatusError::kDataRange);
  EXPECT_EQ(rig.read(1, rig.model.goal_position), 2048);
  EXPECT_EQ(rig.write(1, rig.model.goal_position, 3000), StatusError::kNone);
  // A sync write is refused as silently as it is obeyed.
  EXPECT_THAT(rig.say(dxl::sync_write({{116, 4}, {{1, {0, 0, 0, 0}}}})), IsEmpty());
  EXPECT_EQ(rig.read(1, rig.model.goal_position), 3000);
}

TEST_F(ServoErrors, TheStatusReturnLevelDecidesWhatIsAnswered) {
  rig.say(dxl::write(1, 68, Bytes{1}));
  EXPECT_THAT(rig.say(dxl::write(1, 65, Bytes{1})), IsEmpty());
  EXPECT_EQ(rig.read(1, {65, dxl::Type::kU8, 1}), 1);
  rig.say(dxl::write(1, 68, Bytes{0}));
  EXPECT_THAT(rig.say(dxl::read(1, {132, 4})), IsEmpty());
  EXPECT_EQ(rig.say(dxl::ping(1)).size(), 14U);
}

TEST_F(ServoErrors, HeatTakesTheTorqueUntilAReboot) {
  rig.write(1, rig.model.torque_enable, 1);
  rig.board->suffer(suffering("hot TL0 79"));
  EXPECT_EQ(rig.read(1, rig.model.present_temperature), 79);
  EXPECT_TRUE(rig.board->drive().powered[0]);

  rig.board->suffer(suffering("hot TL0 85"));
  const dxl::Status status = rig.ask(dxl::read(1, rig.model.hardware_error_status.region()));
  EXPECT_TRUE(status.alert);
  EXPECT_THAT(status.data, ElementsAre(dxl::kOverheatingError));
  EXPECT_FALSE(rig.board->drive().powered[0]);
  EXPECT_FALSE(rig.ask(dxl::ping(2)).alert) << "the others are well";
  EXPECT_EQ(rig.write(1, rig.model.torque_enable, 1), StatusError::kResultFail);

  rig.board->suffer({});  // it has cooled down
  EXPECT_EQ(rig.write(1, rig.model.torque_enable, 1), StatusError::kResultFail);
  rig.ask(dxl::reboot(1));
  constexpr std::int64_t kBackNs = 400'000'000;
  EXPECT_EQ(rig.write(1, rig.model.torque_enable, 1, kBackNs), StatusError::kNone);
  EXPECT_EQ(rig.read(1, rig.model.present_temperature, kBackNs), kServoTemperatureC);
}

TEST_F(ServoErrors, MoreCurrentIsMeasuredInTheDirectionOfTheTorque) {
  rig.body.torque_nm[0] = 1;
  rig.write(1, rig.model.torque_enable, 1);
  rig.board->sense(rig.body);
  const auto before = rig.read(1, rig.model.present_current);
  rig.board->suffer(suffering("current TL0 2"));
  const auto after = rig.read(1, rig.model.present_current);
  EXPECT_NEAR(static_cast<double>(std::abs(after) - std::abs(before)) * 2.69e-3, 2, 0.003);
  EXPECT_GT(after * before, 0);
}

}  // namespace
}  // namespace scarab::emulator
