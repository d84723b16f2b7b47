// scarab-topic as a person calls it.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>

#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/bus/fixture.hpp"

namespace scarab::bus {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

struct Outcome {
  int exit_code = -1;
  std::string output;  ///< standard output and error
};

struct TopicTool : testing::Test {
  ParticipantOptions options = test_options("plant");
  Participant plant{options};
  Writer<scarab_JointCommand> commands{plant, kJointCommand};
  Writer<scarab_RobotState> states{plant, kRobotState};

  void SetUp() override {
    scarab_RobotState state{};
    state.header.tick = 5;
    states.write(state);  // kept for late readers
  }

  Outcome run(const std::string& arguments, const std::string& prefix = "") const {
    const std::string command =
        prefix + SCARAB_BIN_DIR "/scarab-topic " + arguments + " --tag '" + options.tag + "' 2>&1";
    Outcome outcome;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return outcome;
    std::array<char, 4096> buffer;
    std::size_t size = 0;
    while ((size = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0) {
      outcome.output.append(buffer.data(), size);
    }
    outcome.exit_code = WEXITSTATUS(pclose(pipe));
    return outcome;
  }
};

TEST_F(TopicTool, ListsTopicsWithTypeAndPeers) {
  const Outcome outcome = run("list --verbose");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("scarab/joint_command"), HasSubstr("scarab::JointCommand"),
                    HasSubstr("plant/0"), HasSubstr("reliable, transient-local")));
}

TEST_F(TopicTool, EchoesOneSample) {
  const Outcome json = run("echo scarab/robot_state --count 1 --json");
  EXPECT_EQ(json.exit_code, 0) << json.output;
  EXPECT_THAT(json.output, AllOf(StartsWith("{\"header\": {\"trial\": 0, \"tick\": 5, "),
                                 HasSubstr("\"phase\": \"PHASE_RUNNING\""), EndsWith("}\n")));
  const Outcome yaml = run("echo scarab/robot_state --count 1");
  EXPECT_EQ(yaml.exit_code, 0) << yaml.output;
  EXPECT_THAT(yaml.output,
              AllOf(StartsWith("header:\n  trial: 0\n  tick: 5\n"), EndsWith("---\n")));
}

TEST_F(TopicTool, SaysWhichTopicsThereAre) {
  const Outcome outcome = run("echo scarab/nothing --timeout 0.5");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("no such topic: scarab/nothing has no writer in domain 0; "
                                        "there are: scarab/joint_command, scarab/robot_state"));
}

TEST_F(TopicTool, RefusesBadUsage) {
  EXPECT_EQ(run("shout scarab/robot_state").exit_code, 2);
  EXPECT_EQ(run("echo").exit_code, 2);
  EXPECT_EQ(run("echo scarab/robot_state --count 0").exit_code, 2);
}

TEST_F(TopicTool, StopsCleanlyOnCtrlC) {
  const Outcome outcome = run("echo scarab/robot_state", "timeout --signal INT --kill-after 10 1 ");
  // timeout says 124 when the signal was needed, 137 when even that did not end it.
  EXPECT_EQ(outcome.exit_code, 124) << outcome.output;
  EXPECT_THAT(outcome.output, EndsWith("---\n"));
}

}  // namespace
}  // namespace scarab::bus
