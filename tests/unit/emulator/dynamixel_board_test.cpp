// Instructions and answers as ROBOTIS prints them (e-Manual, "DYNAMIXEL Protocol 2.0", the example
// of each instruction), where its servos stand as ours here: nothing of these was made by our own
// encoder.

#include <gmock/gmock.h>

#include <cmath>

#include "tests/unit/emulator/dynamixel_rig.hpp"
#include "tests/unit/emulator/suffering.hpp"

namespace scarab::emulator {
namespace {

using testing::Bytes;
using testing::DynamixelRig;
using ::testing::ElementsAre;
using testing::hex;
using ::testing::IsEmpty;
using testing::suffering;

class Board : public ::testing::Test {
 protected:
  DynamixelRig rig;
};

TEST_F(Board, AnswersAPing) {
  // Model 1020 = 0x03FC and this firmware, 45 = 0x2D, in place of the manual's; so another CRC.
  const Bytes answer = rig.say("FF FF FD 00 01 03 00 01 19 4E");
  ASSERT_EQ(answer.size(), 14U);
  EXPECT_EQ(Bytes(answer.begin(), answer.end() - 2), hex("FF FF FD 00 01 07 00 55 00 FC 03 2D"));
  EXPECT_EQ(rig.replies.front().delay_ns, 500'000) << "return delay time, initially 250 of 2 us";
  EXPECT_EQ(rig.say("FF FF FD 00 FE 03 00 01 31 42").size(), 20 * 14U) << "everybody";
}

TEST_F(Board, AnswersARead) {
  rig.stand_at({{1, 166}});
  EXPECT_EQ(rig.say("FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"),
            hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"));
}

TEST_F(Board, AnswersAWriteAndObeysIt) {
  EXPECT_EQ(rig.say("FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89"),
            hex("FF FF FD 00 01 04 00 55 00 A1 0C"));
  EXPECT_EQ(rig.read(1, rig.model.goal_position), 512);
  EXPECT_NEAR(rig.board->drive().target_rad[0], rig.joint_rad(1, 512), 1e-12);
  EXPECT_THAT(rig.noted("goal"), ElementsAre("TL0 2.3562"));
}

TEST_F(Board, AnswersASyncReadOneByOne) {
  rig.stand_at({{1, 166}, {2, 2079}});
  EXPECT_EQ(rig.say("FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA"),
            hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0 "
                "FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE"));
  EXPECT_EQ(rig.replies.size(), 2U);
}

TEST_F(Board, AnswersAFastSyncReadInOnePacket) {
  rig.stand_at({{3, 166}, {7, 2079}, {4, 1023}});
  EXPECT_EQ(rig.say("FF FF FD 00 FE 0A 00 8A 84 00 04 00 03 07 04 20 F2"),
            hex("FF FF FD 00 FE 19 00 55 00 03 A6 00 00 00 84 08 "
                "00 07 1F 08 00 00 16 CA 00 04 FF 03 00 00 D1 9E"));
  EXPECT_EQ(rig.replies.size(), 1U);
}

TEST_F(Board, ObeysASyncWriteWithoutAWord) {
  EXPECT_THAT(rig.say("FF FF FD 00 FE 11 00 83 74 00 04 00 01 96 00 00 00 02 AA 00 00 00 82 87"),
              IsEmpty());
  EXPECT_EQ(rig.read(1, rig.model.goal_position), 150);
  EXPECT_EQ(rig.read(2, rig.model.goal_position), 170);
}

TEST_F(Board, HoldsBackARegisteredWriteUntilTheAction) {
  const Bytes goal{0, 2, 0, 0};
  EXPECT_EQ(rig.ask(dxl::reg_write(1, 116, goal)).error, dxl::StatusError::kNone);
  EXPECT_EQ(rig.read(1, rig.model.goal_position), 2048);
  EXPECT_EQ(rig.say("FF FF FD 00 01 03 00 05 02 CE"), hex("FF FF FD 00 01 04 00 55 00 A1 0C"));
  EXPECT_EQ(rig.read(1, rig.model.goal_position), 512);
}

TEST_F(Board, RebootsToItsFirstState) {
  rig.write(1, rig.model.goal_position, 512);
  rig.write(1, rig.model.torque_enable, 1);
  EXPECT_EQ(rig.say(hex("FF FF FD 00 01 03 00 08 2F 4E"), 0),
            hex("FF FF FD 00 01 04 00 55 00 A1 0C"));
  EXPECT_THAT(rig.say(dxl::ping(1), 100'000'000), IsEmpty()) << "it is away";
  constexpr std::int64_t kBackNs = 400'000'000;
  EXPECT_EQ(rig.read(1, rig.model.goal_position, kBackNs), 2048);
  EXPECT_EQ(rig.read(1, rig.model.torque_enable, kBackNs), 0);
  EXPECT_FALSE(rig.board->drive().powered[0]);
}

TEST_F(Board, TorqueIsPower) {
  EXPECT_TRUE(rig.board->drive().powered.none());
  EXPECT_EQ(rig.board->power_ups(), 0U);
  rig.write(5, rig.model.torque_enable, 1);
  EXPECT_EQ(rig.board->drive().powered.count(), 1U);
  EXPECT_TRUE(rig.board->drive().powered[4]);
  rig.write(5, rig.model.torque_enable, 1);
  EXPECT_EQ(rig.board->power_ups(), 2U) << "also where it had power";
  rig.write(5, rig.model.torque_enable, 0);
  EXPECT_TRUE(rig.board->drive().powered.none());
  EXPECT_THAT(rig.noted("torque_on"), ElementsAre("TR1"));
  EXPECT_THAT(rig.noted("torque_off"), ElementsAre("TR1"));
}

TEST_F(Board, TellsHowTheJointMoves) {
  const long turn = rig.calibration.joints[0]->direction;
  rig.body.velocity_rad_s[0] = 1;
  rig.body.torque_nm[0] = -2;
  rig.board->sense(rig.body);
  EXPECT_EQ(rig.read(1, rig.model.present_velocity),
            turn * std::lround(1 / (0.229 * 2 * M_PI / 60)));
  EXPECT_EQ(rig.read(1, rig.model.present_current), 0) << "without torque there is no current";
  rig.write(1, rig.model.torque_enable, 1);
  rig.board->sense(rig.body);
  EXPECT_EQ(rig.read(1, rig.model.present_current),
            -turn * std::lround(2 / rig.model.torque_constant_nm_a / 2.69e-3));
}

TEST_F(Board, TheImuIsADeviceOfTheBus) {
  rig.body.pitch_rad = 0.25;
  rig.body.acceleration_m_s2 = {0, 0, 9.81};
  rig.board->sense(rig.body);
  const auto pitch = [&] {
    return dxl::value_in(
        rig.config.imu->pitch,
        rig.ask(dxl::read(rig.config.imu->id, rig.config.imu->pitch.region())).data);
  };
  EXPECT_NEAR(pitch(), 0.25, 1e-6);
  rig.board->suffer(suffering("tilt 0.5"));
  rig.board->sense(rig.body);
  EXPECT_NEAR(pitch(), 0.75, 1e-6);
  EXPECT_EQ(rig.write(rig.config.imu->id, rig.config.imu->pitch, 0), dxl::StatusError::kAccess);
  rig.board->suffer(suffering("silent imu"));
  EXPECT_THAT(rig.say(dxl::ping(rig.config.imu->id)), IsEmpty());
}

TEST_F(Board, ASilentServoNeitherHearsNorAnswersNorLetsOthersSpeakBehindIt) {
  rig.board->suffer(suffering("silent TL1"));
  EXPECT_THAT(rig.say(dxl::ping(2)), IsEmpty());
  rig.stand_at({{1, 166}});
  EXPECT_EQ(rig.say("FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA"),
            hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"));
  EXPECT_EQ(rig.say(dxl::sync_read({132, 4}, {1, 2, 3})).size(), 15U);
  // The beginning of the packet that all three would have made.
  const Bytes fast = rig.say(dxl::fast_sync_read({132, 4}, {1, 2, 3}));
  ASSERT_EQ(fast.size(), 16U);
  EXPECT_EQ(fast[5], 2 + 3 * 8 - 1) << "LEN of three";
  rig.say(dxl::sync_write({{116, 4}, {{2, {1, 0, 0, 0}}}}));
  rig.board->suffer({});
  EXPECT_EQ(rig.read(2, rig.model.goal_position), 2048);
}

TEST_F(Board, AnswersNoStatusAndFindsAPacketInGarbage) {
  EXPECT_THAT(rig.say("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"), IsEmpty());
  EXPECT_EQ(rig.say("00 FF FF FD 00 12 FF FF FF FD 00 01 03 00 01 19 4E").size(), 14U);
}

}  // namespace
}  // namespace scarab::emulator
