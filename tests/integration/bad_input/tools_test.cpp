#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/commands.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Matcher;
using testing::StartsWith;

/// A person's slip: one line that names it, exit code 2, nothing on stdout.
void expect_refused(const std::string& name, Arguments words, const Matcher<std::string>& said) {
  words.insert(words.begin(), program(name));
  const auto result = run(words);
  const std::string line = testing::PrintToString(words);
  EXPECT_EQ(result.exit_code, 2) << line << result.out << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << line << result.err;
  EXPECT_EQ(result.out, "") << line;
  EXPECT_THAT(result.err, AllOf(StartsWith(name + ": "), said)) << line;
}

/// A tool that does what its first word says.
class BadWords : public testing::TestWithParam<const char*> {};

TEST_P(BadWords, WithoutACommand) { expect_refused(GetParam(), {}, HasSubstr("required")); }

TEST_P(BadWords, UnknownCommandIsNamedWithTheOneThatWasMeant) {
  for (const std::string& command : commands_of(GetParam())) {
    expect_refused(GetParam(), {command + "x"},
                   AllOf(HasSubstr("'" + command + "x'"), HasSubstr("did you mean")));
  }
  expect_refused(GetParam(), {"frobnicate"}, HasSubstr("unknown command 'frobnicate'"));
}

TEST_P(BadWords, UnknownOptionOfEveryCommandIsNamed) {
  for (const std::string& command : commands_of(GetParam())) {
    expect_refused(GetParam(), {command, "--no-such-option"}, HasSubstr("'--no-such-option'"));
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, BadWords,
                         testing::Values("scarab-config", "scarab-log", "scarab-operator",
                                         "scarab-search", "scarab-topic"),
                         [](const auto& of_case) {
                           return std::string(of_case.param).substr(sizeof("scarab-") - 1);
                         });

TEST(BadLog, FileThatIsNotThereIsNamedByEveryCommandThatReadsOne) {
  const TemporaryDirectory directory;
  const std::string none = directory / "none.mcap";
  for (const std::string& command : commands_of("scarab-log")) {
    expect_refused("scarab-log", {command, none}, HasSubstr(none));
  }
}

TEST(BadLog, CommandsWithoutAFile) {
  for (const std::string& command : commands_of("scarab-log")) {
    expect_refused("scarab-log", {command}, HasSubstr("required"));
  }
}

TEST(BadTopic, BusThatCannotBeIsRefusedByEveryCommand) {
  for (const std::string& command : commands_of("scarab-topic")) {
    expect_refused("scarab-topic", {command, "--domain", "231"}, HasSubstr("--domain"));
  }
}

TEST(BadTopic, CommandsOfATopicNeedOne) {
  for (const std::string command : {"echo", "hz", "bw", "delay", "type", "pub", "wait"}) {
    expect_refused("scarab-topic", {command}, HasSubstr("topic"));
  }
}

TEST(BadTopic, NumbersOutOfRange) {
  expect_refused("scarab-topic", {"echo", "a", "--timeout", "-1"}, HasSubstr("--timeout"));
  expect_refused("scarab-topic", {"echo", "a", "--timeout", "soon"}, HasSubstr("--timeout"));
  expect_refused("scarab-topic", {"echo", "a", "-n", "0"},
                 HasSubstr("--count: Value 0 is too small"));
}

}  // namespace
}  // namespace scarab::test
