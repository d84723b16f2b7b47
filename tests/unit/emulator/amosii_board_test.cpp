#include <gmock/gmock.h>

#include <filesystem>
#include <tuple>

#include "common/config/robot_file.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "services/robot_bridge/config.hpp"
#include "tests/unit/emulator/suffering.hpp"
#include "tools/emulator/boards/amosii/board.hpp"

/// The board's line (facts: the laboratory's public serial interface to it; protocol/frames.hpp).
namespace scarab::emulator {
namespace {

using ::testing::IsEmpty;
using testing::suffering;
using Bytes = std::vector<std::uint8_t>;

/// A set frame with every servo in the middle of its travel, worked out by hand
/// (tests/unit/robot_bridge/amosii/frames_test.cpp shows how).
Bytes middle() {
  return {1,   125, 128, 128, 128, 128, 128, 128, 128, 115, 97, 126, 124, 140, 151, 128, 128,
          128, 128, 140, 160, 126, 124, 115, 95,  151, 124, 96, 115, 126, 140, 128, 128, 0};
}

std::filesystem::path source_file(const char* relative) {
  return std::filesystem::path(SCARAB_SOURCE_DIR) / relative;
}

class Amosii : public ::testing::Test {
 protected:
  Amosii() {
    const auto bridge = bridge::load_config(source_file("config/robot_bridge/beetle-amosii.yaml"));
    config = *std::get<std::optional<bridge::amosii::Config>>(bridge.sections);
    const auto robot = config::load_robot(source_file("config/robot/beetle.yaml"));
    calibration = bridge::load_calibration(bridge.calibration, robot);
    board = std::make_unique<AmosiiBoard>(
        config, robot, calibration, [this](std::string_view event, const std::string& detail) {
          notes.push_back(std::string(event) + " " + detail);
        });
  }
  Bytes say(const Bytes& bytes) {
    std::vector<Reply> replies;
    for (const std::uint8_t byte : bytes) board->on_byte(byte, 0, replies);
    Bytes all;
    for (const Reply& reply : replies) {
      all.insert(all.end(), reply.bytes.begin(), reply.bytes.end());
    }
    return all;
  }
  /// Value p[slot] of the answer to a get.
  int input(std::size_t slot) {
    const Bytes reply = say({2, 0});
    EXPECT_EQ(reply.size(), 33U);
    return reply.size() == 33 ? reply[slot - 1] : -1;
  }

  std::vector<std::string> notes;
  bridge::amosii::Config config;
  bridge::Calibration calibration;
  plant::Observation body;
  std::unique_ptr<AmosiiBoard> board;
};

TEST_F(Amosii, ASetIsNotAnsweredAndPowersTheServos) {
  EXPECT_TRUE(board->drive().powered.none());
  EXPECT_THAT(say(middle()), IsEmpty());
  EXPECT_TRUE(board->drive().powered.all());
  EXPECT_EQ(board->power_ups(), 1U);
  board->put_back();
  EXPECT_TRUE(board->drive().powered.none()) << "until the next set";
}

TEST_F(Amosii, GoalsAreFractionsOfTheServosTravel) {
  say(middle());
  for (std::size_t j = 0; j < robot::kJointCount; ++j) {
    const auto& c = *calibration.joints[j];
    const double middle_rad = bridge::to_joint_rad(c, (c.min_rad + c.max_rad) / 2);
    const double step_rad = (c.max_rad - c.min_rad) / 170;  // of the shortest travel in bytes
    EXPECT_NEAR(board->drive().target_rad[j], middle_rad, step_rad) << robot::kJointNames[j];
  }
  notes.clear();
  Bytes frame = middle();
  frame[1] = 250;  // slot 1, the backbone, at -1
  say(frame);
  EXPECT_THAT(notes, ::testing::SizeIs(1)) << "one goal has changed";
  const auto& c = *calibration.joints[robot::kBackboneSlot];
  EXPECT_NEAR(board->drive().target_rad[robot::kBackboneSlot], bridge::to_joint_rad(c, c.min_rad),
              0.01);
}

TEST_F(Amosii, AGetIsAnsweredWhateverFollowsIt) {
  const Bytes reply = say({2, 0, 17, 3, 200, 255});
  ASSERT_EQ(reply.size(), 33U);
  EXPECT_EQ(reply.back(), 0);
  EXPECT_EQ(std::count(reply.begin(), reply.end() - 1, 0), 0) << "0 ends a reply";
  EXPECT_EQ(say({9, 9, 2, 0}).size(), 33U);
}

TEST_F(Amosii, FeetAreScaledAsPublished) {
  body.foot_force_n = {0, config.foot_full_scale_n, 0, 0, 0, config.foot_full_scale_n / 2};
  board->sense(body);
  EXPECT_EQ(input(14), 40) << "L0 off the ground";
  EXPECT_EQ(input(12), 130) << "L1 at full load";
  EXPECT_EQ(input(13), 15) << "R0 off the ground";
  EXPECT_EQ(input(9), 70) << "R2 half way from 30 to 110";
}

TEST_F(Amosii, InclinationAndCurrentAreLines) {
  body.roll_rad = 0.1;
  body.pitch_rad = -0.2;
  body.supply_current_a = 5.28;
  board->sense(body);
  EXPECT_EQ(input(8), 138);
  EXPECT_EQ(input(7), 108);
  EXPECT_EQ(input(29), 128) << "no servo has power";
  say(middle());
  EXPECT_EQ(input(29), 138);
  board->suffer(suffering("current TR0 5.28"));
  EXPECT_EQ(input(29), 148);
  board->suffer(suffering("tilt 0.5"));
  EXPECT_EQ(input(7), 158);
  board->suffer(suffering("silent imu"));
  EXPECT_EQ(input(7), 128);
}

TEST_F(Amosii, ASilentServoHearsNothing) {
  board->suffer(suffering("silent BJ"));
  say(middle());
  EXPECT_EQ(board->drive().powered.count(), robot::kJointCount - 1);
  EXPECT_FALSE(board->drive().powered[robot::kBackboneSlot]);
}

TEST_F(Amosii, AFrameThatCannotBeIsNotObeyed) {
  Bytes frame = middle();
  frame[2] = 7;  // an output without a servo
  EXPECT_THAT(say(frame), IsEmpty());
  EXPECT_TRUE(board->drive().powered.none());
  EXPECT_THAT(notes, ::testing::ElementsAre(::testing::HasSubstr("frame_bad")));
  say(middle());
  EXPECT_TRUE(board->drive().powered.all()) << "and the next one is";
}

}  // namespace
}  // namespace scarab::emulator
