#include <gmock/gmock.h>

#include <csignal>

#include "tests/integration/operator/pseudo_terminal.hpp"
#include "tests/support/inbox.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/test_bus.hpp"

// scarab-drive and its terminal, with nobody on the bus but the test: however it ends, the terminal
// is as it was.
namespace scarab::test {
namespace {

using testing::HasSubstr;

PseudoTerminal::Start drive() {
  PseudoTerminal::Start start;
  start.command = {program("scarab-drive"), "--tag", test_tag()};
  return start;
}

constexpr const char* kFirstWords = "SPACE EMERGENCY STOP";

TEST(DriveTerminal, IsAsItWasAfterQuitting) {
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows(kFirstWords)) << terminal.letters();
  EXPECT_FALSE(terminal.is_as_it_was()) << "taken over, while it runs";
  EXPECT_TRUE(terminal.shows("no tick master"));
  terminal.type("q");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.is_as_it_was()) << terminal.output();
  EXPECT_THAT(terminal.letters(), testing::EndsWith("thestackstaysasitis"));
}

TEST(DriveTerminal, IsAsItWasAfterSignals) {
  for (const int number : {SIGINT, SIGTERM}) {
    PseudoTerminal terminal(drive());
    ASSERT_TRUE(terminal.shows(kFirstWords)) << terminal.letters();
    terminal.signal(number);
    EXPECT_EQ(terminal.wait(), 130);
    EXPECT_TRUE(terminal.is_as_it_was()) << terminal.output();
  }
}

TEST(DriveTerminal, IsAsItWasAfterControlC) {
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows(kFirstWords)) << terminal.letters();
  terminal.type("\x03");
  EXPECT_EQ(terminal.wait(), 130);
  EXPECT_TRUE(terminal.is_as_it_was()) << terminal.output();
}

TEST(DriveTerminal, FollowsItsSize) {
  bus::Participant participant(test_options("plant"));
  Inbox<scarab_Operator> said(participant, bus::kOperator);
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows(kFirstWords)) << terminal.letters();
  terminal.resize(60, 10);
  EXPECT_TRUE(terminal.shows("this one has 60 x 10")) << terminal.letters();
  ASSERT_TRUE(eventually([&] { return !said.matched().empty(); }));
  terminal.type(" ");
  EXPECT_TRUE(eventually([&] { return !said.all().empty(); })) << "the stop works all the same";
  terminal.resize(120, 40);
  EXPECT_TRUE(terminal.shows(kFirstWords)) << terminal.letters();
  terminal.type("q");
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(terminal.is_as_it_was());
}

TEST(DriveTerminal, ShowsTheHelp) {
  PseudoTerminal terminal(drive());
  ASSERT_TRUE(terminal.shows(kFirstWords));
  terminal.type("?");
  EXPECT_TRUE(terminal.shows("automatic: the strategy decides again")) << terminal.letters();
}

TEST(DriveTerminal, TooSmallAtTheStartIsRefused) {
  auto start = drive();
  start.columns = 79;
  PseudoTerminal terminal(start);
  EXPECT_EQ(terminal.wait(), 2);
  EXPECT_THAT(terminal.output(),
              HasSubstr("scarab-drive: needs a terminal of 80 x 24, this one has 79 x 30"));
  EXPECT_TRUE(terminal.is_as_it_was());
}

TEST(DriveTerminal, UnknownTypeIsRefused) {
  auto start = drive();
  start.type = "nonsense";
  PseudoTerminal terminal(start);
  EXPECT_EQ(terminal.wait(), 2);
  EXPECT_THAT(terminal.output(), HasSubstr("the terminal type 'nonsense' (TERM) is not known"));
  EXPECT_TRUE(terminal.is_as_it_was());
}

TEST(DriveTerminal, WithoutATerminalItIsRefused) {
  const auto finished = test::run({program("scarab-drive"), "--tag", test_tag()});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_EQ(finished.out, "");
  EXPECT_THAT(finished.err, HasSubstr("scarab-drive: needs a terminal"));
}

TEST(DriveTerminal, HelpHasAnExample) {
  const auto help = test::run({program("scarab-drive"), "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("scarab-drive --trial"));
}

}  // namespace
}  // namespace scarab::test
