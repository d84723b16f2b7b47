#include "services/robot_bridge/drivers/amosii/protocol/frames.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "services/robot_bridge/drivers/amosii/protocol/values.hpp"

/// Nobody has published a recording of the board's line. So the bytes expected here were worked out
/// by hand from the table and the formula of the laboratory's public serial interface
/// (amosIIserialv2, setMotors): s = int((m + 1) / 2 * (max - min) + min), m of C joints less 0.1,
/// then clamped.
namespace scarab::bridge::amosii {
namespace {

using testing::ElementsAreArray;
using Bytes = std::vector<int>;

SetFrame frame_of(const robot::JointVector& commands) {
  Slots slots = all_slots(kMiddle);
  for (std::size_t joint = 0; joint < robot::kJointCount; ++joint) {
    slots[kMotorSlots[joint].slot] = motor_byte(joint, commands[joint]);
  }
  return encode_set(slots);
}

robot::JointVector every_joint(double m) {
  robot::JointVector commands{};
  commands.fill(m);
  return commands;
}

TEST(AmosiiFrames, SetOfAllJointsInTheMiddle) {
  // T left .5 * 234 + 9 = 126, right .5 * -237 + 243 = 124.5; C at m = -.1: .45 * 244 + 6 = 115.8
  // or .45 * -244 + 250 = 140.2; F .5 * (170, -179, -183, -170, 180, 183) + (75, 186, 189, 180, 61,
  // 60) = 160, 96.5, 97.5, 95, 151, 151.5; backbone .5 * -249 + 250 = 125.5.
  const Bytes expected = {1,                                  // set
                          125,                                // 1 BJ
                          128, 128, 128, 128, 128, 128, 128,  // 2-8 nothing
                          115, 97,  126, 124, 140, 151,       // 9 CL2, FL2, TL2, TR2, CR2, FR2
                          128, 128, 128, 128,                 // 15-18 nothing
                          140, 160, 126, 124, 115, 95,        // 19 CL0, FL0, TL0, TR0, CR0, FR0
                          151, 124, 96,  115, 126, 140,       // 25 FR1, TR1, FL1, CL1, TL1, CR1
                          128, 128,                           // 31, 32 nothing
                          0};
  EXPECT_THAT(frame_of(every_joint(0)), ElementsAreArray(expected));
}

TEST(AmosiiFrames, SetOfAllJointsAtPlusOne) {
  // C at m = .9: .95 * 244 + 6 = 237.8 or .95 * -244 + 250 = 18.2; all others at their `max`.
  const Bytes expected = {1,  1,   128, 128, 128, 128, 128, 128, 128, 237, 6, 243,
                          6,  18,  243, 128, 128, 128, 128, 18,  245, 243, 6, 237,
                          10, 241, 6,   7,   237, 243, 18,  128, 128, 0};
  EXPECT_THAT(frame_of(every_joint(1)), ElementsAreArray(expected));
}

TEST(AmosiiFrames, SetOfAllJointsAtMinusOne) {
  // C at m = -1.1, clamped to -1: all joints at their `min`.
  const Bytes expected = {1,   250, 128, 128, 128, 128, 128, 128, 128, 6, 189, 9,
                          243, 250, 60,  128, 128, 128, 128, 250, 75,  9, 243, 6,
                          180, 61,  243, 186, 6,   9,   250, 128, 128, 0};
  EXPECT_THAT(frame_of(every_joint(-1)), ElementsAreArray(expected));
}

TEST(AmosiiFrames, SetOfLeftLegsForwardsAndRightOnesBack) {
  robot::JointVector commands{};
  for (const robot::Leg leg : robot::kLegs) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      commands[robot::joint_slot(leg, static_cast<robot::LegJoint>(joint))] =
          robot::is_left(leg) ? 0.5 : -0.5;
    }
  }
  // Left, .75: T 184.5; C at .4, .7: 79.2 (CL0) or 176.8; F 202.5, 51.75, 51.75.
  // Right, .25: T 183.75; C at -.6, .2: 54.8 (CR0) or 201.2; F 137.5, 106, 105.75. Backbone 125.5.
  const Bytes expected = {1,   125, 128, 128, 128, 128, 128, 128, 128, 176, 51,  184,
                          183, 201, 105, 128, 128, 128, 128, 79,  202, 184, 183, 54,
                          137, 106, 183, 51,  176, 184, 201, 128, 128, 0};
  EXPECT_THAT(frame_of(commands), ElementsAreArray(expected));
}

/// The published slots and bytes for m = -1 and +1, in the order of the publication.
TEST(AmosiiFrames, EachJointHasItsOwnSlot) {
  struct Published {
    const char* joint;
    std::size_t slot;
    int at_minus_one;
    int at_plus_one;
  };
  constexpr std::array<Published, robot::kJointCount> kPublished = {{
      {"TR0", 22, 243, 6},  {"TR1", 26, 243, 6},  {"TR2", 12, 243, 6},  {"TL0", 21, 9, 243},
      {"TL1", 29, 9, 243},  {"TL2", 11, 9, 243},  {"CR0", 23, 6, 237},  {"CR1", 30, 250, 18},
      {"CR2", 13, 250, 18}, {"CL0", 19, 250, 18}, {"CL1", 28, 6, 237},  {"CL2", 9, 6, 237},
      {"FR0", 24, 180, 10}, {"FR1", 25, 61, 241}, {"FR2", 14, 60, 243}, {"FL0", 20, 75, 245},
      {"FL1", 27, 186, 7},  {"FL2", 10, 189, 6},  {"BJ", 1, 250, 1},
  }};
  const SetFrame middle = frame_of(every_joint(0));
  for (const Published& servo : kPublished) {
    std::size_t joint = 0;
    while (robot::kJointNames[joint] != servo.joint) ++joint;
    for (const double m : {-1.0, 1.0}) {
      robot::JointVector commands{};
      commands[joint] = m;
      SetFrame expected = middle;
      expected[servo.slot] =
          static_cast<std::uint8_t>(m < 0 ? servo.at_minus_one : servo.at_plus_one);
      EXPECT_EQ(frame_of(commands), expected) << servo.joint << " at " << m;
    }
  }
}

TEST(AmosiiFrames, GetIsTwoBytes) { EXPECT_THAT(kGetFrame, testing::ElementsAre(2, 0)); }

TEST(AmosiiFrames, ReplyHasItsSlotsInOrderAndOneZeroAtItsEnd) {
  Slots sensors;
  for (std::size_t slot = 1; slot <= kSlotCount; ++slot) {
    sensors[slot] = static_cast<std::uint8_t>(slot == 5 ? 0 : 200 - slot);
  }
  Bytes expected;
  for (int slot = 1; slot <= 32; ++slot) expected.push_back(slot == 5 ? 1 : 200 - slot);
  expected.push_back(0);
  EXPECT_THAT(encode_reply(sensors), ElementsAreArray(expected));
}

TEST(AmosiiFrames, ACycleTakesTwelveMilliseconds) {
  const double cycle_s = wire_time_s(std::tuple_size_v<SetFrame> + std::tuple_size_v<GetFrame> +
                                     std::tuple_size_v<ReplyFrame>);
  EXPECT_NEAR(cycle_s, 69 * 10 / 57600.0, 1e-12);
}

TEST(AmosiiFrames, APlausibleSetHasServosAboveZeroAndNothingElsewhere) {
  Slots motors = all_slots(kMiddle);
  EXPECT_TRUE(is_plausible_set(motors));
  motors[19] = 1;
  EXPECT_TRUE(is_plausible_set(motors));
  motors[19] = 0;
  EXPECT_FALSE(is_plausible_set(motors));
  for (const std::size_t unused : {2, 3, 4, 5, 6, 7, 8, 15, 16, 17, 18, 31, 32}) {
    motors = all_slots(kMiddle);
    motors[unused] = 127;
    EXPECT_FALSE(is_plausible_set(motors)) << unused;
  }
}

TEST(AmosiiFrames, APlausibleReplyHasZerosOnlyWhereNoMinimumIsPublished) {
  for (std::size_t slot = 1; slot <= kSlotCount; ++slot) {
    Slots sensors = all_slots(kMiddle);
    sensors[slot] = 0;
    const bool may_be_zero = std::vector<bool>{
        false, false, true,  true,  true,  true,  true,  true,  false, false, false,
        false, false, false, false, true,  true,  false, true,  true,  true,  true,
        false, true,  false, false, false, false, true,  false, true,  false}[slot - 1];
    EXPECT_EQ(is_plausible_reply(sensors), may_be_zero) << slot;
  }
}

}  // namespace
}  // namespace scarab::bridge::amosii
