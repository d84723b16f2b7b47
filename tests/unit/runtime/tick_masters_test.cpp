#include "common/runtime/tick_masters.hpp"

#include <gmock/gmock.h>

#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TickMasters, AreThePlantAndTheRobotBridge) {
  EXPECT_TRUE(is_tick_master({"plant", 0}));
  EXPECT_TRUE(is_tick_master({"robot_bridge", 0}));
  EXPECT_FALSE(is_tick_master({"premotor", 0}));
  EXPECT_FALSE(is_tick_master({}));
}

TEST(TickMasters, TheExpectedOneIsKnownByName) {
  EXPECT_EQ(expected_tick_master({{"premotor", 1}, {"robot_bridge", 1}}),
            (bus::Peer{"robot_bridge", 0}));
  EXPECT_EQ(expected_tick_master({{"plant", 1}}), (bus::Peer{"plant", 0}));
  EXPECT_EQ(expected_tick_master({{"plant", 0}, {"logger", 1}}), std::nullopt);
  EXPECT_EQ(expected_tick_master({}), std::nullopt);
}

TEST(TickMasters, WhicheverIsExpectedIsNeeded) {
  bus::Participant participant(test::test_options("premotor"));
  const bus::Writer<scarab_JointCommand> commands(participant, bus::kJointCommand);
  const auto unmet = [&](const Expectation& expect) {
    PeerCheck peers(expect);
    need_tick_master(peers, commands);
    return peers.unmet();
  };
  EXPECT_THAT(unmet({{"robot_bridge", 1}}),
              ElementsAre("robot_bridge/0 to read scarab/joint_command"));
  EXPECT_THAT(unmet({{"plant", 1}}), ElementsAre("plant/0 to read scarab/joint_command"));
  EXPECT_THAT(unmet({{"logger", 1}}), IsEmpty());
}

}  // namespace
}  // namespace scarab::runtime
