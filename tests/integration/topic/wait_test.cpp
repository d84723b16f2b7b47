#include <csignal>

#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

struct Wait : TopicTool {
  bus::Writer<scarab_JointCommand> writer{plant_, bus::kJointCommand};
};

TEST_F(Wait, ReturnsAsSoonAsItIsTrue) {
  ChildProcess one = start_topic({"wait", "scarab/joint_command", "--timeout", "20"});
  ChildProcess two = start_topic({"wait", "scarab/joint_command", "-n", "2", "--timeout", "20"});
  ChildProcess tick = start_topic(
      {"wait", "scarab/joint_command", "--filter", "header.tick = 7", "--timeout", "20"});
  ASSERT_TRUE(eventually([&] { return writer.matched().size() == 3; }));
  writer.write(joint_command(6));
  EXPECT_EQ(one.wait(kPatience), 0);
  EXPECT_TRUE(two.running());
  writer.write(joint_command(7));
  EXPECT_EQ(two.wait(kPatience), 0);
  EXPECT_EQ(tick.wait(kPatience), 0);
  EXPECT_EQ(one.output() + two.output() + tick.output(), "");
}

TEST_F(Wait, WaitsForTheTopicToo) {
  ChildProcess wait = start_topic({"wait", "later", "--timeout", "20"});
  const AnyWriter later(plant_, "later", bus::descriptor<scarab_JointCommand>());
  const scarab_JointCommand sample{};
  ASSERT_TRUE(wait.running());
  const_cast<AnyWriter&>(later).write(&sample);
  EXPECT_EQ(wait.wait(kPatience), 0) << wait.err();
}

TEST_F(Wait, TellsWhyItGaveUp) {
  expect_refused(3, {"wait", "scarab/joint_command", "--timeout", "0.4"},
                 "scarab/joint_command: 0 samples within 0.4 s");
  expect_refused(4, {"wait", "nowhere", "--timeout", "0.4"}, "no topic nowhere in domain 0");
  expect_refused(2, {"wait", "scarab/joint_command", "--filter", "tick = 7", "--timeout", "5"},
                 "--filter: column 1: no member tick in scarab::JointCommand");
  expect_refused(2, {"wait", "scarab/joint_command", "--hz", "0"}, "--hz");
}

TEST_F(Wait, IsInterrupted) {
  ChildProcess wait = start_topic({"wait", "scarab/joint_command"});
  ASSERT_TRUE(eventually([&] { return !writer.matched().empty(); }));
  wait.signal(SIGINT);
  EXPECT_EQ(wait.wait(kPatience), 130);
}

}  // namespace
}  // namespace scarab::test
