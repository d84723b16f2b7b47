#include "common/runtime/usage_error.hpp"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>

namespace scarab::runtime {
namespace {

using testing::HasSubstr;

/// What is said of a command line of a program with commands; empty where it is a good one.
std::string said_of(const std::vector<std::string>& words) {
  CLI::App app{"A test program.", "scarab-test"};
  app.require_subcommand(1);
  bool flag = false;
  std::string text;
  double number = 0;
  app.add_flag("--quietly", flag);
  app.add_option("--rate", number)->check(CLI::PositiveNumber);
  app.add_option("--share", number)->check(CLI::Range(0.0, 1.0));
  app.add_subcommand("list", "")->add_flag("--verbose", flag);
  CLI::App* echo = app.add_subcommand("echo", "");
  echo->add_option("topic", text)->required();
  echo->add_option("--format", text)->required();
  app.add_subcommand("lost", "")->group("");
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    return usage_error(app, error);
  }
  return "";
}

TEST(UsageError, MisspeltCommandIsNamedWithTheOneThatWasMeant) {
  EXPECT_EQ(said_of({"ehco", "scarab/trial"}), "unknown command 'ehco'; did you mean 'echo'?");
}

TEST(UsageError, CommandThatResemblesNoneIsToldThoseThatThereAre) {
  EXPECT_EQ(said_of({"trial.mcap"}), "unknown command 'trial.mcap'; there are list, echo");
}

TEST(UsageError, MisspeltOptionIsNamedEvenWhereTheRightOneIsMissing) {
  EXPECT_EQ(said_of({"echo", "a", "--fromat=csv"}),
            "unknown option '--fromat'; did you mean '--format'?");
  EXPECT_EQ(said_of({"list", "--verbos"}), "unknown option '--verbos'; did you mean '--verbose'?");
  EXPECT_EQ(said_of({"--quitely", "list"}),
            "unknown option '--quitely'; did you mean '--quietly'?");
  EXPECT_EQ(said_of({"list", "--no-such"}), "unknown option '--no-such'");
}

TEST(UsageError, OptionOfAnotherCommandIsUnknown) {
  EXPECT_EQ(said_of({"list", "--format", "csv"}), "unknown option '--format'");
}

TEST(UsageError, OptionOfTheProgramIsSentToItsPlace) {
  EXPECT_EQ(said_of({"list", "--rate", "3"}), "option '--rate' belongs before the command");
}

TEST(UsageError, WordTooMuchIsNamed) {
  EXPECT_EQ(said_of({"list", "scarab/trial"}), "unexpected argument 'scarab/trial'");
}

TEST(UsageError, WhatIsMissingIsNamed) {
  EXPECT_THAT(said_of({}), HasSubstr("subcommand is required"));
  EXPECT_THAT(said_of({"echo", "--format", "csv"}), HasSubstr("topic"));
  EXPECT_THAT(said_of({"echo", "a"}), HasSubstr("--format"));
}

TEST(UsageError, RangeIsToldWhereItHasAnEnd) {
  EXPECT_EQ(said_of({"--rate", "0", "list"}), "--rate: Value 0 is too small");
  EXPECT_THAT(said_of({"--share", "2", "list"}), HasSubstr("--share: Value 2 not in range"));
}

TEST(UsageError, NothingIsSaidOfAGoodLine) {
  EXPECT_EQ(said_of({"echo", "a", "--format", "csv"}), "");
}

}  // namespace
}  // namespace scarab::runtime
