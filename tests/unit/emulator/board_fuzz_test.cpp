#include <gtest/gtest.h>

#include "common/random/random.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"
#include "tests/unit/emulator/dynamixel_rig.hpp"

/// Whatever comes in, only whole statuses go out, and the next instruction is answered.
namespace scarab::emulator {
namespace {

using testing::Bytes;
using testing::DynamixelRig;

/// Draws of one seed, one after the other.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  std::size_t below(std::size_t limit) {
    return random::bits(seed_, random::stream("fuzz"), index_++) % limit;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(256)); }
  Bytes bytes(std::size_t most) {
    Bytes out(below(most + 1));
    for (std::uint8_t& each : out) each = byte();
    return out;
  }

 private:
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

/// Any instruction, known or not, to anybody, with parameters that mean something or not. Status
/// return levels stay as they are: a device that says nothing would prove nothing.
dxl::Packet any_packet(Dice& dice) {
  const auto id =
      static_cast<std::uint8_t>(dice.below(4) == 0 ? dxl::kBroadcastId : dice.below(22));
  switch (dice.below(4)) {
    case 0:
      return dxl::read(id, {static_cast<std::uint16_t>(dice.below(700)),
                            static_cast<std::uint16_t>(dice.below(700))});
    case 1:
      return dxl::write(id, static_cast<std::uint16_t>(70 + dice.below(80)), dice.bytes(8));
    case 2:
      return {dxl::kBroadcastId, static_cast<std::uint8_t>(0x80 + dice.below(16)), dice.bytes(40)};
    default:
      return {id, static_cast<std::uint8_t>(0x20 + dice.below(0x60)), dice.bytes(20)};
  }
}

Bytes damaged(Bytes frame, Dice& dice) {
  switch (dice.below(4)) {
    case 0:
      frame[dice.below(frame.size())] ^= static_cast<std::uint8_t>(1U << dice.below(8));
      break;
    case 1:
      frame.erase(frame.begin() + static_cast<long>(dice.below(frame.size())));
      break;
    case 2:
      frame.insert(frame.begin() + static_cast<long>(dice.below(frame.size())), dice.byte());
      break;
    default:
      break;  // whole
  }
  return frame;
}

/// Every reply is one whole status and nothing beside it.
void expect_whole(const std::vector<Reply>& replies) {
  for (const Reply& reply : replies) {
    dxl::Parser parser;
    std::vector<dxl::Packet> packets;
    parser.feed(reply.bytes, packets);
    ASSERT_EQ(packets.size(), 1U);
    ASSERT_TRUE(packets.front().is_status());
    ASSERT_EQ(parser.counters().bytes_dropped, 0U);
  }
}

TEST(BoardFuzz, OnlyWholeStatusesGoOut) {
  DynamixelRig rig;
  Dice dice(1);
  std::size_t answered = 0;
  for (int i = 0; i < 20000; ++i) {
    rig.say(damaged(dxl::encode(any_packet(dice)), dice), i * 1'000'000LL);
    rig.board->tick(i * 1'000'000LL);
    expect_whole(rig.replies);
    ASSERT_FALSE(HasFatalFailure()) << "stream " << i;
    answered += rig.replies.size();
  }
  EXPECT_GT(answered, 1000U) << "it has been asked something";
}

TEST(BoardFuzz, AfterAnyGarbageTheSecondPingIsAnswered) {
  DynamixelRig rig;
  Dice dice(2);
  for (int i = 0; i < 5000; ++i) {
    rig.say(damaged(dxl::encode(any_packet(dice)), dice));
    rig.say(dice.bytes(30));
    const Bytes ping = dxl::encode(dxl::ping(200));  // the IMU: no packet above has changed it
    rig.say(ping);
    ASSERT_GE(rig.say(ping).size(), 14U) << "stream " << i;
  }
}

}  // namespace
}  // namespace scarab::emulator
