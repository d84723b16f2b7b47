#include "tools/drive/keys.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace scarab::drive {
namespace {

using Kind = Action::Kind;
using supervisor::Mode;
using testing::HasSubstr;

constexpr Inputs kBackward = {0, 1, 0, 0};
constexpr std::array<Page, 5> kPages = {Page::kMain, Page::kStrategies, Page::kConfirmReset,
                                        Page::kConfirmStop, Page::kHelp};

Key key(char character) { return static_cast<Key>(character); }

/// A keyboard, the inputs that hold, and a menu.
struct Person {
  Keyboard keyboard;
  Inputs live = kBackward;
  std::vector<std::string> strategies = {"soft", "boxing", "soft+hard"};

  Action press(Key pressed) { return drive::press(keyboard, pressed, live, strategies); }
  Action press(char character) { return press(key(character)); }
};

TEST(Keys, SpaceIsTheEmergencyStopOnEveryPage) {
  for (const Page page : kPages) {
    Person person;
    person.keyboard.page = page;
    const Action action = person.press(' ');
    EXPECT_EQ(action.kind, Kind::kOrder);
    EXPECT_EQ(action.order.command, scarab_OPERATOR_EMERGENCY_STOP);
    EXPECT_EQ(person.keyboard.page, Page::kMain) << "the live state shows what came of it";
  }
}

TEST(Keys, OnlySpaceIsTheEmergencyStop) {
  for (int code = 0; code < 0x110; ++code) {
    if (code == ' ') continue;
    for (const Page page : kPages) {
      Person person;
      person.keyboard.page = page;
      const Action action = person.press(static_cast<Key>(code));
      EXPECT_FALSE(action.kind == Kind::kOrder &&
                   action.order.command == scarab_OPERATOR_EMERGENCY_STOP)
          << code;
    }
  }
}

TEST(Keys, EveryModeHasAKey) {
  std::set<Mode> modes;
  for (char c = 'a'; c <= 'z'; ++c) {
    Person person;
    const Action action = person.press(c);
    if (action.kind != Kind::kOrder || action.order.command != scarab_OPERATOR_MODE) continue;
    EXPECT_THAT(action.order.name, HasSubstr(std::string(name(action.order.word.mode))));
    EXPECT_TRUE(modes.insert(action.order.word.mode).second);
  }
  EXPECT_EQ(modes.size(), supervisor::kModeNames.size());
}

TEST(Keys, TickMasterIsToldByOneKey) {
  const std::vector<std::pair<char, scarab_OperatorCommand>> expected = {
      {'p', scarab_OPERATOR_PAUSE}, {'g', scarab_OPERATOR_START}, {'n', scarab_OPERATOR_STEP}};
  for (const auto& [character, command] : expected) {
    const Action action = Person().press(character);
    EXPECT_EQ(action.kind, Kind::kOrder);
    EXPECT_EQ(action.order.command, command);
  }
}

TEST(Keys, ResetAndStopAskFirst) {
  const std::vector<std::pair<char, scarab_OperatorCommand>> expected = {
      {'r', scarab_OPERATOR_RESET}, {'e', scarab_OPERATOR_STOP}};
  for (const auto& [character, command] : expected) {
    Person person;
    EXPECT_EQ(person.press(character).kind, Kind::kNothing);
    const Action action = person.press('y');
    EXPECT_EQ(action.kind, Kind::kOrder);
    EXPECT_EQ(action.order.command, command);
    EXPECT_EQ(person.press('y').kind, Kind::kNothing) << "asked once, answered once";
  }
}

TEST(Keys, AnythingButYesIsNo) {
  for (int code = 0; code < 0x110; ++code) {
    if (code == 'y' || code == ' ' || code == static_cast<int>(Key::kRedraw)) continue;
    Person person;
    person.press('r');
    EXPECT_EQ(person.press(static_cast<Key>(code)).kind, Kind::kNothing) << code;
    EXPECT_EQ(person.keyboard.page, Page::kMain);
  }
}

TEST(Keys, InputsStepFromThoseThatHold) {
  Person person;
  person.live = {1, 0, 0, -0.3};
  person.press('4');
  const Action action = person.press(Key::kUp);
  EXPECT_EQ(action.order.command, scarab_OPERATOR_INPUTS);
  EXPECT_EQ(action.order.word.inputs, (Inputs{1, 0, 0, -0.2}));
}

TEST(Keys, QuickStepsAddUpBeforeTheRobotFollows) {
  Person person;
  person.press('3');
  person.press(Key::kUp);
  person.press(Key::kUp);
  const Action action = person.press(Key::kUp);
  EXPECT_EQ(action.order.word.inputs, (Inputs{0, 1, 0.3, 0}));
}

TEST(Keys, StepsLeadBackExactly) {
  Person person;
  for (int i = 0; i < 7; ++i) person.press(Key::kUp);
  Action action;
  for (int i = 0; i < 7; ++i) action = person.press(Key::kDown);
  EXPECT_EQ(action.order.word.inputs, kBackward);
}

TEST(Keys, InputsStayWithinTheirRange) {
  Person person;
  for (int i = 0; i < 30; ++i) {
    for (const double input : person.press(Key::kUp).order.word.inputs) EXPECT_LE(input, 1);
  }
  for (int i = 0; i < 60; ++i) {
    for (const double input : person.press(Key::kDown).order.word.inputs) EXPECT_GE(input, -1);
  }
  EXPECT_EQ((*person.keyboard.by_hand)[0], -1);
}

TEST(Keys, AnotherOrderEndsTheHand) {
  for (const char character : {'f', 'a'}) {
    Person person;
    person.press(Key::kUp);
    ASSERT_TRUE(person.keyboard.by_hand);
    person.press(character);
    EXPECT_FALSE(person.keyboard.by_hand);
  }
}

TEST(Keys, FollowsInputsThatSomebodyElseGave) {
  Person person;
  person.press(Key::kUp);
  follow(person.keyboard, {0.1, 1, 0, 0});
  EXPECT_TRUE(person.keyboard.by_hand) << "they hold";
  follow(person.keyboard, {-1, -1, 1, 0});
  EXPECT_FALSE(person.keyboard.by_hand);
}

TEST(Keys, MenuChoosesAStrategy) {
  Person person;
  person.press('m');
  ASSERT_EQ(person.keyboard.page, Page::kStrategies);
  person.press(Key::kUp);
  person.press(Key::kDown);
  for (int i = 0; i < 9; ++i) person.press(Key::kDown);
  const Action action = person.press(Key::kEnter);
  EXPECT_EQ(action.order.command, scarab_OPERATOR_STRATEGY);
  EXPECT_EQ(action.order.word.strategy, "soft+hard") << "the last";
  EXPECT_EQ(person.keyboard.page, Page::kMain);
}

TEST(Keys, MenuIsLeftWithoutAChoice) {
  for (const Key leave : {Key::kEscape, key('q'), key('m')}) {
    Person person;
    person.press('m');
    EXPECT_EQ(person.press(leave).kind, Kind::kNothing);
    EXPECT_EQ(person.keyboard.page, Page::kMain);
  }
}

TEST(Keys, EmptyMenuHasNothingToChoose) {
  Person person;
  person.strategies.clear();
  person.press('m');
  EXPECT_EQ(person.press(Key::kDown).kind, Kind::kNothing);
  EXPECT_EQ(person.press(Key::kEnter).kind, Kind::kNothing);
}

TEST(Keys, HelpNamesEveryKeyThatDoesSomething) {
  std::set<std::string> keys;
  for (const auto& entry : key_help()) {
    std::istringstream words(entry.key);
    for (std::string word; words >> word;) keys.insert(word);
  }
  for (char c = '!'; c <= '~'; ++c) {
    Person person;
    person.keyboard.selected_input = 4;  // none, so that choosing one shows
    const Action action = person.press(c);
    const bool does = action.kind != Kind::kNothing || person.keyboard.page != Page::kMain ||
                      person.keyboard.selected_input != 4;
    EXPECT_EQ(does, keys.count(std::string(1, c)) == 1) << c;
  }
}

TEST(Keys, QuitsAndStartsTrials) {
  EXPECT_EQ(Person().press('q').kind, Kind::kQuit);
  EXPECT_EQ(Person().press('t').kind, Kind::kTrial);
  EXPECT_EQ(Person().press(Key::kRedraw).kind, Kind::kRedraw);
}

}  // namespace
}  // namespace scarab::drive
