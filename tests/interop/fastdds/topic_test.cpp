/// `scarab topic` and a writer that sends no type information: Fast DDS.
#include <sstream>

#include "common/mcap/reader.hpp"
#include "common/sample/idl_parser.hpp"
#include "common/sample/sample_text.hpp"
#include "tests/interop/fastdds/fixture.hpp"
#include "tests/support/eventually.hpp"

namespace scarab::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr int kTypeUnknown = 5;

/// The samples of a topic in a log as `topic echo --json` prints them.
std::vector<std::string> recorded(const std::filesystem::path& log, const std::string& topic) {
  std::vector<std::string> lines;
  const mcap::Reader reader(log);
  reader.for_each(
      [&](const mcap::Channel& channel, const mcap::Message& message) {
        const auto& schema = reader.summary().schemas.at(channel.schema_id);
        const auto* bytes = reinterpret_cast<const std::byte*>(message.data.data());
        const auto type = sample::parse_idl({schema.data.begin(), schema.data.end()}, schema.name);
        lines.push_back(sample::json_text(type, {bytes, message.data.size()}));
      },
      {topic});
  return lines;
}

class FastDdsTopic : public FastDdsTest {
 protected:
  [[nodiscard]] Finished topic(const Arguments& words) const {
    Arguments command = {program("scarab-topic")};
    command.insert(command.end(), words.begin(), words.end());
    const Arguments bus = claim_.host().bus;
    command.insert(command.end(), bus.begin(), bus.end());
    return run(command);
  }

  /// What `list` says once it has heard of `part`: Fast DDS may take 1 s to tell a newcomer of its
  /// endpoints.
  [[nodiscard]] std::string list_with(const std::string& part) const {
    std::string listed;
    EXPECT_TRUE(eventually([&] {
      listed = topic({"list"}).out;
      return listed.find(part) != std::string::npos;
    })) << listed;
    return listed;
  }
};

TEST_F(FastDdsTopic, ListMarksItAndEchoDecodesWhatIsOfATypeOfOurs) {
  Stack::Options options = on_this_domain();
  options.others = {"premotor"};
  Stack stack(directory_ / "run", options);
  const auto premotor = start_premotor(stack);
  auto experiment = stack.conduct(main_trial());
  ASSERT_EQ(experiment.wait(kTrialLimit), 0) << experiment.output() << stack.errors();

  const std::string listed = list_with(
      "premotor/0 sends no type information; its samples are read "
      "as Scarab's own scarab::JointCommand");
  EXPECT_THAT(listed, Not(HasSubstr("supervisor/0 sends no type information")));
  const Finished type = topic({"type", "scarab/joint_command"});
  EXPECT_EQ(type.exit_code, 0) << type.err;
  EXPECT_THAT(type.out, HasSubstr("struct JointCommand"));
  const Finished echo = topic({"echo", "scarab/joint_command", "--once", "--json"});
  EXPECT_EQ(echo.exit_code, 0) << echo.err;

  EXPECT_EQ(premotor->stop(), 0) << premotor->output();
  ASSERT_TRUE(stack.stop()) << stack.errors();
  const std::string line = echo.out.substr(0, echo.out.find('\n'));
  EXPECT_THAT(recorded(stack.log(), "scarab/joint_command"), Contains(line));
}

TEST_F(FastDdsTopic, WhatIsOfNobodysTypeIsListedAndNotDecoded) {
  ChildProcess stranger({program("fastdds-stranger"), "--domain", std::to_string(claim_.domain())},
                        directory_ / "stranger");
  const std::string listed = list_with("sends no type information");
  EXPECT_THAT(listed, HasSubstr("meadow/weather"));
  EXPECT_THAT(listed, HasSubstr("meadow::Weather"));
  const Finished echo = topic({"echo", "meadow/weather", "--once"});
  EXPECT_EQ(echo.exit_code, kTypeUnknown) << echo.out << echo.err;
  EXPECT_THAT(echo.err, HasSubstr("meadow/weather"));
  EXPECT_EQ(stranger.stop(), 0) << stranger.output();
}

}  // namespace
}  // namespace scarab::test
