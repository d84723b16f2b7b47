#include <csignal>

#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct List : TopicTool {
  bus::Writer<scarab_JointCommand> commands{plant_, bus::kJointCommand};
};

TEST_F(List, TellsTopicsWithTypeAndPeers) {
  const Finished list = topic({"list"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_EQ(list.out,
            "TOPIC                 TYPE                  WRITERS  READERS\n"
            "scarab/joint_command  scarab::JointCommand  plant/0  -\n");
  EXPECT_THAT(topic({"list", "--verbose"}).out,
              HasSubstr("    writer plant/0          reliable, transient-local\n"));
}

TEST_F(List, TellsNamesQuickly) {
  const auto begin = std::chrono::steady_clock::now();
  const Finished names = topic({"list", "--names"});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(names.out, "scarab/joint_command\n");
  EXPECT_LT(took.count(), 2.0) << "0.3 s, and a loaded machine";
}

TEST_F(List, TellsEverythingAsJson) {
  const Finished list = topic({"list", "--json"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(
      list.out,
      AllOf(HasSubstr("[{\"topic\": \"scarab/joint_command\", \"type\": "
                      "\"scarab::JointCommand\", \"writers\": [{\"service\": \"plant/0\", "),
            HasSubstr("\"pid\": " + std::to_string(getpid()) + ", "),
            HasSubstr("\"vendor\": \"Cyclone DDS\""), HasSubstr("\"sends_type\": true"),
            HasSubstr("\"readers\": [], \"mismatches\": []}]\n")));
}

TEST_F(List, IsEmptyWhereThereIsNobody) {
  const Finished list = topic({"list", "--json", "--domain", "1", "--timeout", "0.3"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_EQ(list.out, "[]\n");
}

TEST_F(List, MarksWhoGetsNothing) {
  bus::RawQos left = kept();
  left.partitions = {"left"};
  const AnyReader reader(plant_, bus::kJointCommand.name, bus::descriptor<scarab_JointCommand>(),
                         left);
  const Finished list = topic({"list"});
  EXPECT_THAT(list.out, HasSubstr("\n  ! plant/0 gets nothing from plant/0: partition: '' offered, "
                                  "'left' asked\n"));
  EXPECT_THAT(topic({"list", "--json"}).out,
              HasSubstr("\"mismatches\": [{\"policy\": \"partition\", \"offered\": \"''\", "
                        "\"asked\": \"'left'\", \"writer\": \"plant/0\", \"reader\": "));
}

TEST_F(List, MarksWritersThatSendNoType) {
  const auto& operator_type = bus::descriptor<scarab_Operator>();
  const bus::RawWriter own(plant_, "a", disguised(operator_type, "scarab::Operator", false),
                           kept());
  const bus::RawWriter other(plant_, "b", disguised(operator_type, "far::Thing", false), kept());
  const Finished list = topic({"list"});
  EXPECT_THAT(list.out, HasSubstr("  ! plant/0 sends no type information; its samples are read as "
                                  "Scarab's own scarab::Operator\n"));
  EXPECT_THAT(list.out, HasSubstr("  ! plant/0 sends no type information; its samples cannot be "
                                  "decoded\n"));
}

TEST_F(List, ShortensNamesWhereTheTerminalIsNarrow) {
  std::vector<std::unique_ptr<bus::Participant>> participants;
  std::vector<std::unique_ptr<AnyReader>> readers;
  for (std::uint32_t i = 0; i < 4; ++i) {
    participants.push_back(std::make_unique<bus::Participant>(test_options("supervisor", i)));
    readers.push_back(std::make_unique<AnyReader>(*participants.back(), bus::kJointCommand.name,
                                                  bus::descriptor<scarab_JointCommand>()));
  }
  Arguments narrow = {"/usr/bin/env", "COLUMNS=80"};
  const Arguments list = command({"list"});
  narrow.insert(narrow.end(), list.begin(), list.end());
  EXPECT_THAT(run(narrow).out, HasSubstr("plant/0  supervisor/0 +3\n"));
  EXPECT_THAT(topic({"list"}).out,
              HasSubstr("plant/0  supervisor/0, supervisor/1, supervisor/2, supervisor/3\n"));
}

TEST_F(List, WatchesUntilCtrlC) {
  ChildProcess list = start_topic({"list", "--watch", "--json"});
  const auto says = [&](const std::string& text) {
    return eventually([&] { return list.out().find(text) != std::string::npos; });
  };
  ASSERT_TRUE(says("scarab/joint_command")) << list.err();
  {
    const bus::Writer<scarab_Trial> trials(plant_, bus::kTrial);
    ASSERT_TRUE(says("scarab/trial"));
  }
  // The last line: it has gone again.
  ASSERT_TRUE(eventually([&] {
    const std::string out = list.out();
    const std::size_t last = out.rfind('\n', out.size() - 2);
    return last != std::string::npos && out.find("scarab/trial", last) == std::string::npos;
  })) << list.out();
  list.signal(SIGINT);
  EXPECT_EQ(list.wait(kPatience), 0);
}

}  // namespace
}  // namespace scarab::test
