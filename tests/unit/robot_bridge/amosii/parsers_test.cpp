#include "services/robot_bridge/drivers/amosii/protocol/parsers.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace scarab::bridge::amosii {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class Frame>
void append(Bytes& stream, const Frame& frame) {
  stream.insert(stream.end(), frame.begin(), frame.end());
}

struct Heard {
  std::vector<Slots> sets;
  int gets = 0;
};

Heard heard(const Bytes& stream) {
  CommandParser parser;
  Heard heard;
  for (const std::uint8_t byte : stream) {
    const auto command = parser.push(byte);
    if (!command) continue;
    if (const auto* motors = std::get_if<Slots>(&*command)) {
      heard.sets.push_back(*motors);
    } else {
      ++heard.gets;
    }
  }
  return heard;
}

Slots some_motors() {
  Slots motors = all_slots(kMiddle);
  motors[1] = 1;  // the byte of the set command is a servo's byte as well
  motors[19] = 2;
  motors[30] = 250;
  return motors;
}

TEST(AmosiiCommandParser, FindsSetsAndGets) {
  Bytes stream;
  append(stream, encode_set(some_motors()));
  append(stream, kGetFrame);
  append(stream, encode_set(all_slots(kMiddle)));
  const Heard result = heard(stream);
  ASSERT_EQ(result.sets.size(), 2U);
  EXPECT_EQ(result.sets[0].bytes, some_motors().bytes);
  EXPECT_EQ(result.sets[1].bytes, all_slots(kMiddle).bytes);
  EXPECT_EQ(result.gets, 1);
}

/// As the laboratory's software does it: its get is the first 2 of 100 bytes.
TEST(AmosiiCommandParser, ToleratesGarbageBehindAGet) {
  Bytes stream;
  append(stream, kGetFrame);
  stream.push_back(0);
  for (int i = 0; i < 97; ++i) stream.push_back(static_cast<std::uint8_t>(i % 3 == 0 ? 0 : 77 + i));
  append(stream, encode_set(some_motors()));
  append(stream, kGetFrame);
  const Heard result = heard(stream);
  EXPECT_EQ(result.gets, 2);
  ASSERT_EQ(result.sets.size(), 1U);
  EXPECT_EQ(result.sets[0].bytes, some_motors().bytes);
}

TEST(AmosiiCommandParser, LosesOnlyTheDamagedFrame) {
  const SetFrame whole = encode_set(some_motors());
  for (std::size_t lost = 0; lost < whole.size(); ++lost) {
    Bytes stream(whole.begin(), whole.end());
    stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(lost));
    append(stream, encode_set(all_slots(kMiddle)));
    append(stream, kGetFrame);
    const Heard result = heard(stream);
    ASSERT_FALSE(result.sets.empty()) << lost;
    EXPECT_EQ(result.sets.back().bytes, all_slots(kMiddle).bytes) << lost;
    EXPECT_EQ(result.gets, 1) << lost;
  }
}

TEST(AmosiiCommandParser, AShortenedSetAndAGetAreNoSet) {
  // Its last two bytes are lost: with the get they have the length of a set.
  const SetFrame whole = encode_set(some_motors());
  Bytes stream(whole.begin(), whole.end() - 2);
  append(stream, kGetFrame);
  ASSERT_EQ(stream.size(), whole.size());
  const Heard result = heard(stream);
  EXPECT_TRUE(result.sets.empty());
  EXPECT_EQ(result.gets, 1);
}

TEST(AmosiiCommandParser, CountsSetsThatMoveWhatIsNotThere) {
  SetFrame frame = encode_set(some_motors());
  frame[32] = 127;
  CommandParser parser;
  for (const std::uint8_t byte : frame) EXPECT_FALSE(parser.push(byte).has_value());
  EXPECT_EQ(parser.implausible_sets(), 1U);
}

Slots some_sensors() {
  Slots sensors;
  for (std::size_t slot = 1; slot <= kSlotCount; ++slot) {
    sensors[slot] = static_cast<std::uint8_t>(3 * slot);
  }
  return sensors;
}

TEST(AmosiiReplyParser, FindsAReplyWhateverCameBefore) {
  ReplyParser parser;
  parser.expect();
  for (const std::uint8_t byte : Bytes{7, 0, 0, 1, 2, 0, 9})
    EXPECT_FALSE(parser.push(byte).has_value());
  std::vector<Slots> replies;
  for (const std::uint8_t byte : encode_reply(some_sensors())) {
    if (const auto reply = parser.push(byte)) replies.push_back(*reply);
  }
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_EQ(replies[0].bytes, some_sensors().bytes);
}

TEST(AmosiiReplyParser, WaitsWhereTheTerminatorIsWrong) {
  ReplyFrame frame = encode_reply(some_sensors());
  frame.back() = 5;
  ReplyParser parser;
  parser.expect();
  for (const std::uint8_t byte : frame) EXPECT_FALSE(parser.push(byte).has_value());
  EXPECT_EQ(parser.pending(), frame.size());
}

TEST(AmosiiReplyParser, FillsUpNoReplyWithBytesFromBeforeItWasAsked) {
  const ReplyFrame frame = encode_reply(some_sensors());
  ReplyParser parser;
  parser.push(33);
  parser.expect();
  for (std::size_t i = 1; i < frame.size(); ++i) EXPECT_FALSE(parser.push(frame[i]).has_value());
}

TEST(AmosiiReplyParser, InStepTakesZerosOfInputsThatMayReadIt) {
  for (const std::size_t slot : {3, 7, 8, 16, 17, 29, 31}) {
    ReplyFrame frame = encode_reply(some_sensors());
    frame[slot - 1] = 0;
    ReplyParser parser;
    parser.push(33);  // of an exchange before
    parser.expect();
    std::optional<Slots> reply;
    for (const std::uint8_t byte : frame) {
      ASSERT_FALSE(reply.has_value());
      reply = parser.push(byte);
    }
    ASSERT_TRUE(reply.has_value()) << slot;
    EXPECT_EQ((*reply)[slot], 0);
  }
}

}  // namespace
}  // namespace scarab::bridge::amosii
