#include "common/runtime/peers.hpp"

#include <gmock/gmock.h>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::runtime {
namespace {

using test::eventually;
using test::test_options;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PeerCheckTest : public testing::Test {
 protected:
  bus::Participant plant_{test_options("plant")};
  bus::Reader<scarab_JointCommand> commands_{plant_, bus::kJointCommand};
  bus::Writer<scarab_RobotState> states_{plant_, bus::kRobotState};
};

TEST_F(PeerCheckTest, NamesEachPeerThatIsMissing) {
  PeerCheck check({{"premotor", 2}, {"logger", 1}});
  check.need(commands_, "premotor");
  check.need(states_, "logger");
  EXPECT_THAT(check.unmet(), ElementsAre("premotor/0 to write scarab/joint_command",
                                         "premotor/1 to write scarab/joint_command",
                                         "logger/0 to read scarab/robot_state"));
}

TEST_F(PeerCheckTest, WhatIsNotExpectedIsNotNeeded) {
  PeerCheck check({{"premotor", 0}});
  check.need(commands_, "premotor");
  check.need(states_, "logger");
  EXPECT_THAT(check.unmet(), IsEmpty());
}

TEST_F(PeerCheckTest, MetAsSoonAsThePeersHaveMatched) {
  PeerCheck check({{"premotor", 1}});
  check.need(commands_, "premotor");
  ASSERT_FALSE(check.unmet().empty());
  bus::Participant premotor(test_options("premotor"));
  const bus::Writer<scarab_JointCommand> writer(premotor, bus::kJointCommand);
  EXPECT_TRUE(eventually([&] { return check.unmet().empty(); }));
}

TEST_F(PeerCheckTest, UnmetAgainWhenAPeerGoes) {
  PeerCheck check({{"premotor", 1}});
  check.need(commands_, "premotor");
  {
    bus::Participant premotor(test_options("premotor"));
    const bus::Writer<scarab_JointCommand> writer(premotor, bus::kJointCommand);
    ASSERT_TRUE(eventually([&] { return check.unmet().empty(); }));
  }
  EXPECT_TRUE(eventually([&] { return check.unmet().size() == 1; }));
}

TEST_F(PeerCheckTest, AnotherInstanceDoesNotStandIn) {
  PeerCheck check({{"premotor", 1}});
  check.need(commands_, "premotor");
  bus::Participant premotor(test_options("premotor", 1));
  const bus::Writer<scarab_JointCommand> writer(premotor, bus::kJointCommand);
  ASSERT_TRUE(eventually([&] { return !commands_.matched().empty(); }));
  EXPECT_THAT(check.unmet(), Contains("premotor/0 to write scarab/joint_command"));
}

TEST_F(PeerCheckTest, SaysWhenThereAreTooMany) {
  PeerCheck check({{"premotor", 1}});
  check.need(commands_, "premotor");
  bus::Participant first(test_options("premotor", 0));
  bus::Participant second(test_options("premotor", 1));
  const bus::Writer<scarab_JointCommand> first_writer(first, bus::kJointCommand);
  const bus::Writer<scarab_JointCommand> second_writer(second, bus::kJointCommand);
  ASSERT_TRUE(eventually([&] { return commands_.matched().size() == 2; }));
  EXPECT_THAT(check.unmet(),
              ElementsAre("only 1 premotor to write scarab/joint_command (found 2)"));
}

TEST_F(PeerCheckTest, OthersOnTheTopicDoNotCount) {
  PeerCheck check({{"premotor", 0}, {"logger", 0}});
  check.need(commands_, "premotor");
  bus::Participant tool(test_options("topic"));
  const bus::Writer<scarab_JointCommand> writer(tool, bus::kJointCommand);
  ASSERT_TRUE(eventually([&] { return !commands_.matched().empty(); }));
  EXPECT_THAT(check.unmet(), IsEmpty());
}

TEST_F(PeerCheckTest, SaysWhyAnEndpointDoesNotMatch) {
  PeerCheck check({{"premotor", 1}});
  check.need(commands_, "premotor");
  bus::Participant premotor(test_options("premotor"));
  constexpr bus::Topic<scarab_Behaviour> kOtherType{"scarab/joint_command", bus::Profile::kCommand};
  const bus::Writer<scarab_Behaviour> writer(premotor, kOtherType);
  EXPECT_TRUE(eventually([&] { return check.unmet().size() > 1; }));
  EXPECT_THAT(check.unmet(), Contains(HasSubstr("type on scarab/joint_command")));
}

TEST(Join, ReadsLikeASentence) {
  EXPECT_EQ(join({}), "");
  EXPECT_EQ(join({"a"}), "a");
  EXPECT_EQ(join({"a", "b"}), "a and b");
  EXPECT_EQ(join({"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace scarab::runtime
