// Writers that come and go while somebody looks.
#include <memory>

#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

struct Follow : TopicTool {
  /// A writer in a process of its own, as far as DDS can tell.
  struct Program {
    Program(const std::string& service, const bus::RawQos& qos,
            const dds_topic_descriptor_t& type = bus::descriptor<scarab_JointCommand>())
        : participant(test_options(service)), writer(participant, "a", type, qos) {}
    void write(std::uint32_t tick) {
      const scarab_JointCommand sample = joint_command(tick);
      writer.write(&sample);
    }
    bus::Participant participant;
    AnyWriter writer;
  };

  ChildProcess echo_ = start_topic({"echo", "a", "--field", "header.tick", "--timeout", "20"});

  bool printed(const std::string& lines) {
    return eventually([&] { return echo_.out() == lines; });
  }
};

TEST_F(Follow, ARestartedWriter) {
  std::unique_ptr<Program> premotor;
  premotor = std::make_unique<Program>("premotor", kept());
  premotor->write(1);
  ASSERT_TRUE(printed("1\n")) << echo_.output();
  premotor.reset();
  premotor = std::make_unique<Program>("premotor", kept());
  premotor->write(2);
  EXPECT_TRUE(printed("1\n2\n")) << echo_.output();
}

TEST_F(Follow, AWriterOfAnotherPartitionAndOfAnotherReliability) {
  Program first("premotor", kept());
  first.write(1);
  ASSERT_TRUE(printed("1\n")) << echo_.output();
  bus::RawQos left = kept();
  left.partitions = {"left"};
  Program second("supervisor", left);
  second.write(2);
  ASSERT_TRUE(printed("1\n2\n")) << echo_.output();
  // It matches both readers there are by now: each sample must come once all the same.
  bus::RawQos both = kept();
  both.partitions = {"", "left"};
  Program third("logger", both);
  third.write(3);
  ASSERT_TRUE(printed("1\n2\n3\n")) << echo_.output();
  bus::RawQos weak;
  weak.reliability = DDS_RELIABILITY_BEST_EFFORT;
  Program fourth("drive", weak);
  ASSERT_TRUE(eventually([&] { return !fourth.writer.matched().empty(); }));
  fourth.write(4);
  first.write(5);
  third.write(6);
  EXPECT_TRUE(eventually([&] {
    const std::string out = echo_.out();
    return out.find("4\n") != std::string::npos && out.find("5\n") != std::string::npos &&
           out.find("6\n") != std::string::npos;
  })) << echo_.output();
  EXPECT_EQ(echo_.out().size(), std::string("1\n2\n3\n4\n5\n6\n").size()) << echo_.out();
}

TEST_F(Follow, ATypeThatIsNotTheFirstOnesIsNamed) {
  Program first("premotor", kept());
  first.write(1);
  ASSERT_TRUE(printed("1\n")) << echo_.output();
  Program other("supervisor", kept(), bus::descriptor<scarab_Trial>());
  EXPECT_TRUE(eventually([&] {
    return echo_.err() == "scarab-topic: cannot follow supervisor/0: its type is another one\n";
  })) << echo_.output();
  first.write(2);
  EXPECT_TRUE(printed("1\n2\n")) << echo_.output();
}

TEST_F(Follow, ANewVersionOfTheType) {
  std::unique_ptr<Program> old;
  old = std::make_unique<Program>("premotor", kept());
  old->write(1);
  ASSERT_TRUE(printed("1\n")) << echo_.output();
  old.reset();
  // The same name, and a header that begins alike.
  const bus::TopicType newer =
      disguised(bus::descriptor<scarab_Trial>(), "scarab::JointCommand", true);
  Program renewed("premotor", kept(), *newer);
  scarab_Trial trial{};
  trial.header.tick = 7;
  renewed.writer.write(&trial);
  EXPECT_TRUE(printed("1\n7\n")) << echo_.output();
}

}  // namespace
}  // namespace scarab::test
