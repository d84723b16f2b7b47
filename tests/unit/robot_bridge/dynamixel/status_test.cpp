#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"

#include <gtest/gtest.h>

#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "tests/unit/robot_bridge/dynamixel/frames.hpp"

namespace scarab::bridge::dynamixel {
namespace {

TEST(Status, AlertAndErrorShareAByte) {
  const auto status = as_status({7, 0x55, hex("84 01 02")});
  ASSERT_TRUE(status);
  EXPECT_TRUE(status->alert);
  EXPECT_EQ(status->error, StatusError::kDataRange);
  EXPECT_EQ(status->data, hex("01 02"));
  EXPECT_EQ(error_byte(*status), 0x84);
  EXPECT_EQ(as_status(to_packet(*status)), status);
}

TEST(Status, ErrorsHaveNames) {
  EXPECT_EQ(name_of(StatusError::kResultFail), "result fail");
  EXPECT_EQ(name_of(StatusError::kAccess), "access error");
  EXPECT_EQ(name_of(static_cast<StatusError>(42)), "error 42");
}

TEST(Status, OtherPacketsAreNone) {
  EXPECT_FALSE(as_status(ping(1)));
  EXPECT_FALSE(as_status({1, 0x55, {}}));                 // no error byte
  EXPECT_FALSE(as_status({kBroadcastId, 0x55, {0x00}}));  // of all
}

TEST(FastStatus, OtherPacketsAreNone) {
  EXPECT_FALSE(as_fast_status({1, 0x55, Bytes(6)}, 4));
  EXPECT_TRUE(as_fast_status({kBroadcastId, 0x55, Bytes(6)}, 4));
  EXPECT_FALSE(as_fast_status({kBroadcastId, 0x55, Bytes(6)}, 5));
  EXPECT_FALSE(as_fast_status({kBroadcastId, 0x8A, Bytes(6)}, 4));
  EXPECT_TRUE(answered_so_far(encode(ping(1)), 4).empty());
}

}  // namespace
}  // namespace scarab::bridge::dynamixel
