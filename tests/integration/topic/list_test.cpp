#include <gmock/gmock.h>

#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

struct List : TopicTool {
  bus::Participant plant{test_options("plant")};
  bus::Writer<scarab_JointCommand> commands{plant, bus::kJointCommand};
};

TEST_F(List, TellsTopicsWithTypeAndPeers) {
  const Finished list = topic({"list"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_EQ(list.out,
            "TOPIC                 TYPE                  WRITERS  READERS\n"
            "scarab/joint_command  scarab::JointCommand  plant/0  -\n");
}

}  // namespace
}  // namespace scarab::test
