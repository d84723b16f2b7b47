#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/unit/robot_bridge/dynamixel/frames.hpp"

namespace scarab::bridge::dynamixel {
namespace {

Packet cut(Packet packet, std::size_t parameters) {
  packet.parameters.resize(parameters);
  return packet;
}

TEST(Instructions, ADeviceReadsWhatAControllerBuilds) {
  EXPECT_EQ(as_read(read(1, {132, 10})), (Region{132, 10}));

  for (const Packet& packet : {write(1, 116, hex("01 02")), reg_write(1, 116, hex("01 02"))}) {
    const auto request = as_write(packet);
    ASSERT_TRUE(request);
    EXPECT_EQ(request->address, 116);
    EXPECT_EQ(request->data, hex("01 02"));
  }
  for (const Packet& packet :
       {sync_read({126, 10}, {1, 2, 3}), fast_sync_read({126, 10}, {1, 2, 3})}) {
    const auto request = as_sync_read(packet);
    ASSERT_TRUE(request);
    EXPECT_EQ(request->region, (Region{126, 10}));
    EXPECT_EQ(request->ids, (std::vector<std::uint8_t>{1, 2, 3}));
  }
  const auto request = as_sync_write(sync_write({{64, 1}, {{4, {1}}, {5, {0}}}}));
  ASSERT_TRUE(request);
  ASSERT_EQ(request->items.size(), 2U);
  EXPECT_EQ(request->items[1].id, 5);
  EXPECT_EQ(request->items[1].data, Bytes{0});
}

TEST(Instructions, OthersAreNotMistakenForThem) {
  EXPECT_FALSE(as_read(sync_read({132, 4}, {1})));
  EXPECT_FALSE(as_write(read(1, {132, 4})));
  EXPECT_FALSE(as_sync_read(sync_write({{64, 1}, {{4, {1}}}})));
  EXPECT_FALSE(as_sync_write(sync_read({64, 1}, {4, 1})));
}

TEST(Instructions, ParametersThatMakeNoSenseAreRefused) {
  EXPECT_FALSE(as_read(cut(read(1, {132, 4}), 3)));
  EXPECT_FALSE(as_write(cut(write(1, 116, hex("01")), 2)));
  EXPECT_FALSE(as_sync_read(cut(sync_read({132, 4}, {1}), 4)));
  const Packet two = sync_write({{116, 4}, {{1, Bytes(4)}, {2, Bytes(4)}}});
  EXPECT_TRUE(as_sync_write(two));
  EXPECT_FALSE(as_sync_write(cut(two, two.parameters.size() - 1)));
  EXPECT_FALSE(as_sync_write({kBroadcastId, 0x83, hex("74 00 00 00 01 02")}));  // of no bytes
  EXPECT_FALSE(as_ping_answer(hex("06 04")));
}

TEST(Instructions, ItemsOfASyncWriteAreAsLongAsItsRegion) {
  EXPECT_THROW(sync_write({{116, 4}, {{1, Bytes(3)}}}), std::invalid_argument);
}

TEST(Instructions, APacketHasALongestLength) {
  EXPECT_NO_THROW(encode(write(1, 0, Bytes(kMaxLength - 5))));
  EXPECT_THROW(encode(write(1, 0, Bytes(kMaxLength - 4))), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
