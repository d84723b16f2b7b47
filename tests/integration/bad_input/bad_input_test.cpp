#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A service as it is called in the stack, by its name.
class BadInput : public testing::TestWithParam<const char*> {
 protected:
  /// Runs it with the shipped files and `more`; it has to end by itself.
  Finished run_with(const Arguments& more) const {
    return run_with_files(shipped_files(name()), more);
  }
  Finished run_with_files(const Arguments& files, const Arguments& more) const {
    Arguments command = {program(program_of(name())), "--tag", test_tag(), "--run-dir",
                         directory_.path()};
    if (name() == "logger") command.insert(command.end(), {"--output", directory_ / "a.mcap"});
    command.insert(command.end(), files.begin(), files.end());
    command.insert(command.end(), more.begin(), more.end());
    return run(command);
  }
  static std::string name() { return GetParam(); }
  [[nodiscard]] bool nothing_made() const { return std::filesystem::is_empty(directory_.path()); }

  void expect_refused(const Finished& result) const {
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(nothing_made()) << "something was started";
  }

  TemporaryDirectory directory_;
  TemporaryDirectory files_;
};

/// The value of --config or --robot among arguments.
std::string& file_of(Arguments& arguments, const std::string& option) {
  return *std::next(std::find(arguments.begin(), arguments.end(), option));
}

TEST_P(BadInput, UnknownOption) {
  const auto result = run_with({"--no-such-option", "1"});
  expect_refused(result);
  EXPECT_THAT(result.err, HasSubstr("--no-such-option"));
}

TEST_P(BadInput, BadExpectation) {
  const auto result = run_with({"--expect", "plant"});
  expect_refused(result);
  EXPECT_THAT(result.err, HasSubstr("'plant'"));
}

TEST_P(BadInput, InterfaceThatIsNotThere) {
  const auto result = run_with({"--interface", "nosuch7"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("nosuch7"));
}

INSTANTIATE_TEST_SUITE_P(Services, BadInput,
                         testing::Values("plant", "supervisor", "premotor", "logger",
                                         "robot_bridge", "emulator"),
                         [](const auto& of_case) { return std::string(of_case.param); });

/// Those that cannot do without a configuration file.
using BadFile = BadInput;

TEST_P(BadFile, MissingFile) {
  Arguments files = shipped_files(name());
  file_of(files, "--config") = files_ / "none.yaml";
  const auto result = run_with_files(files, {});
  expect_refused(result);
  EXPECT_THAT(result.err, HasSubstr((files_ / "none.yaml").string()));
}

TEST_P(BadFile, NoConfigurationAtAll) {
  Arguments files = shipped_files(name());
  const auto option = std::find(files.begin(), files.end(), "--config");
  files.erase(option, std::next(option, 2));
  expect_refused(run_with_files(files, {}));
}

TEST_P(BadFile, UnknownKeyIsNamedWithItsPlace) {
  Arguments files = shipped_files(name());
  const std::string text = read_text(file_of(files, "--config"));
  const auto bad = files_ / "bad.yaml";
  write_text(bad, text + "\nno_such_key: 1\n");
  file_of(files, "--config") = bad;
  const auto result = run_with_files(files, {});
  expect_refused(result);
  const auto line = std::count(text.begin(), text.end(), '\n') + 2;
  EXPECT_THAT(result.err,
              StartsWith(bad.string() + ":" + std::to_string(line) + ":1: no_such_key: "));
  EXPECT_EQ(run_with_files(files, {"--check"}).exit_code, 2);
}

TEST_P(BadFile, CheckSaysNothingOfAGoodOne) {
  const auto result = run_with({"--check"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_TRUE(nothing_made());
}

TEST_P(BadFile, DumpedConfigurationIsReadBackTheSame) {
  const auto first = run_with({"--dump-config"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  Arguments files = shipped_files(name());
  const auto dumped = files_ / "dumped.yaml";
  write_text(dumped, first.out);
  file_of(files, "--config") = dumped;
  const auto second = run_with_files(files, {"--dump-config"});
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_EQ(second.out, first.out);
}

/// A robot may be described that Simbody cannot move.
using BadRobot = BadInput;

TEST_P(BadRobot, ASegmentWithoutLengthIsRefusedBeforeAnythingStarts) {
  Arguments files = shipped_files(name());
  std::string text = read_text(file_of(files, "--robot"));
  const std::string coxa = "coxa: {length_m: 0.035";
  text.replace(text.find(coxa), coxa.size(), "coxa: {length_m: 0.0");
  file_of(files, "--robot") = files_ / "robot.yaml";
  write_text(files_ / "robot.yaml", text);
  const auto result = run_with_files(files, {});
  expect_refused(result);
  EXPECT_THAT(result.err, HasSubstr("robot.yaml:1:1: (top level): leg segment length"));
}

INSTANTIATE_TEST_SUITE_P(Services, BadRobot, testing::Values("plant"),
                         [](const auto& of_case) { return std::string(of_case.param); });

INSTANTIATE_TEST_SUITE_P(Services, BadFile,
                         testing::Values("plant", "supervisor", "premotor", "robot_bridge",
                                         "emulator"),
                         [](const auto& of_case) { return std::string(of_case.param); });

}  // namespace
}  // namespace scarab::test
