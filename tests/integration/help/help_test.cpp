#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/commands.hpp"
#include "tests/support/programs.hpp"

namespace scarab::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

/// All programs of this build that a person can call.
std::vector<std::string> programs() {
  std::vector<std::string> names;
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(program("")).parent_path())) {
    const std::string name = file.path().filename();
    if (name.rfind("scarab-", 0) == 0) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Help, OfEveryProgramHasAnExampleOfItself) {
  ASSERT_GE(programs().size(), 13U);
  for (const auto& name : programs()) {
    const auto result = run({program(name), "--help"});
    EXPECT_EQ(result.exit_code, 0) << name;
    EXPECT_EQ(result.err, "") << name;
    EXPECT_THAT(result.out, AnyOf(HasSubstr("Example"), HasSubstr("example"))) << name;
    const auto example = result.out.find("xample");
    EXPECT_NE(result.out.find(name + " ", example), std::string::npos) << name;
  }
}

TEST(Help, OfEveryCommandHasAnExampleOfItself) {
  std::size_t commands = 0;
  for (const auto& name : programs()) {
    for (const auto& command : commands_of(name)) {
      ++commands;
      const auto result = run({program(name), command, "--help"});
      const std::string what = name + " " + command;
      EXPECT_EQ(result.exit_code, 0) << what;
      EXPECT_EQ(result.err, "") << what;
      const auto example = result.out.find("xample");
      ASSERT_NE(example, std::string::npos) << what;
      EXPECT_NE(result.out.find(what, example), std::string::npos) << what << " has no example";
    }
  }
  EXPECT_GE(commands, 30U);
}

}  // namespace
}  // namespace scarab::test
