#include "tools/drive/view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace scarab::drive {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> kStrategies = {"soft", "boxing"};

Live walking() {
  Live live;
  live.where = "domain 3";
  live.tick_master = "plant/0";
  live.tick_master_answers = true;
  live.trial_runs = true;
  live.trial = 7;
  live.tick = 421;
  live.time_s = 42.1;
  live.ticks_per_s = 10;
  live.real_time = true;
  live.phase = "running";
  live.has_joint.fill(true);
  live.position_rad.fill(0.25);
  live.state = "approach";
  live.reason = "the trial runs";
  live.mode = "backward";
  live.inputs = {0, 1, 0, -0.3};
  live.bs_rad = 0.03;
  live.bs_threshold_rad = 0.15;
  live.as_rad = 1.01;
  live.as_threshold_rad = 0.951;
  live.services = {{"plant/0", "active", Concern::kNone, ""},
                   {"premotor/0", "active", Concern::kWaits, "waits for supervisor/0"}};
  live.timing = {0.0002, 0.0011, 0.0025, 0.0071};
  return live;
}

std::vector<Line> lines_of(const Live& live, const Keyboard& keyboard = {},
                           const Notice& notice = {}, Size size = kSmallest) {
  return draw(live, keyboard, kStrategies, notice, size);
}

std::string text_of(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) text += plain(line) + "\n";
  return text;
}

bool has_style(const std::vector<Line>& lines, Style style, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
    return std::any_of(line.begin(), line.end(), [&](const Span& span) {
      return span.style == style && span.text.find(part) != std::string::npos;
    });
  });
}

TEST(View, ShowsWhatTheRobotDoes) {
  EXPECT_THAT(
      text_of(lines_of(walking())),
      AllOf(HasSubstr("domain 3"), HasSubstr("plant/0, real time"),
            HasSubstr("trial 7  tick 421  42.1 s  10.0 ticks/s  running"), HasSubstr("approach"),
            HasSubstr("mode backward"), HasSubstr("the trial runs"), HasSubstr("I2 +1.00"),
            HasSubstr("I4 -0.30"), HasSubstr("BS +0.030"), HasSubstr("AS +1.010"),
            HasSubstr("0.150"), HasSubstr("0.951"), HasSubstr("+0.25")));
}

TEST(View, ShowsHowTimeIsKept) {
  Live live = walking();
  EXPECT_THAT(text_of(lines_of(live)), AllOf(HasSubstr("command age p99 2.5 ms max 7.1 ms"),
                                             HasSubstr("tick jitter p99 0.2 ms max 1.1 ms")));
  live.real_time = false;
  EXPECT_THAT(text_of(lines_of(live)), AllOf(HasSubstr("lockstep"), Not(HasSubstr("jitter"))))
      << "lockstep has no clock";
}

TEST(View, ShowsWhatServicesSay) {
  const auto lines = lines_of(walking());
  EXPECT_TRUE(has_style(lines, Style::kWarning, "waits for supervisor/0"));
}

TEST(View, ShowsRefusedCommandsByReason) {
  Live live = walking();
  EXPECT_THAT(text_of(lines_of(live)), HasSubstr("refused  no command"));
  live.refused = {{"stale", 3}, {"finite", 1}};
  live.clamped = 12;
  EXPECT_THAT(text_of(lines_of(live)),
              AllOf(HasSubstr("stale 3"), HasSubstr("finite 1"), HasSubstr("clamped 12")));
}

TEST(View, SafeStopCannotBeOverlooked) {
  Live live = walking();
  EXPECT_FALSE(has_style(lines_of(live), Style::kAlarm, "SAFE STOP"));
  live.safe_stop = true;
  live.tick_master_says = "safe stop: operator emergency stop: smoke";
  EXPECT_TRUE(
      has_style(lines_of(live), Style::kAlarm, "SAFE STOP  operator emergency stop: smoke"));
  live.trial_runs = false;
  EXPECT_TRUE(has_style(lines_of(live), Style::kAlarm, "SAFE STOP")) << "it is latched";
}

TEST(View, ShowsHoming) {
  Live live = walking();
  live.phase = "homing";
  EXPECT_TRUE(has_style(lines_of(live), Style::kWarning, "HOMING"));
}

TEST(View, ShowsTheSignalThatSwitchesInThePlaceOfAs) {
  Live live = walking();
  live.by_load = true;
  live.trigger = "supply current";
  live.trigger_unit = "A";
  live.trigger_value = 5.25;
  live.trigger_threshold = 8.9;
  EXPECT_THAT(
      text_of(lines_of(live)),
      AllOf(HasSubstr("IS +5.250 A"), HasSubstr("8.900 supply current"), Not(HasSubstr("AS "))));
  live.trigger_value = 9.5;
  EXPECT_THAT(text_of(lines_of(live)), HasSubstr("8.900 above: blocked"));
}

TEST(View, ComparesSignalsWithTheirThresholds) {
  Live live = walking();
  EXPECT_THAT(text_of(lines_of(live)), AllOf(Not(HasSubstr("above")), Not(HasSubstr("below"))));
  live.bs_rad = 0.16;
  live.as_rad = 0.94;
  EXPECT_THAT(text_of(lines_of(live)), AllOf(HasSubstr("above"), HasSubstr("below")));
}

TEST(View, MarksTheChosenInput) {
  Keyboard keyboard;
  keyboard.selected_input = 2;
  const auto lines = lines_of(walking(), keyboard);
  EXPECT_TRUE(has_style(lines, Style::kSelected, "I3"));
  EXPECT_FALSE(has_style(lines, Style::kSelected, "I1"));
}

TEST(View, ShowsAbsentJointsAsAbsent) {
  Live live = walking();
  live.has_joint.fill(false);
  EXPECT_THAT(text_of(lines_of(live)), Not(HasSubstr("+0.25")));
}

TEST(View, SaysThatNothingIsThere) {
  EXPECT_THAT(text_of(lines_of({})),
              AllOf(HasSubstr("no tick master"), HasSubstr("no trial yet: t starts one"),
                    HasSubstr("no behaviour heard of yet")));
  Live over = walking();
  over.trial_runs = false;
  over.phase = "failed";
  EXPECT_THAT(text_of(lines_of(over)), HasSubstr("failed; no trial runs: t starts one"));
}

TEST(View, TickMasterThatIsGoneCannotBeOverlooked) {
  Live live = walking();
  live.tick_master_answers = live.trial_runs = false;
  EXPECT_THAT(text_of(lines_of(live)), HasSubstr("running when last heard of"));
  EXPECT_TRUE(has_style(lines_of(live), Style::kAlarm, "plant/0 does not answer"));
}

TEST(View, AsksBeforeAReset) {
  Keyboard keyboard;
  keyboard.page = Page::kConfirmReset;
  EXPECT_THAT(text_of(lines_of(walking(), keyboard)),
              AllOf(HasSubstr("Leave the safe stop?"), HasSubstr("y: yes"), HasSubstr("SPACE")));
}

TEST(View, EveryPageSaysWhereTheEmergencyStopIs) {
  for (const Page page :
       {Page::kMain, Page::kStrategies, Page::kConfirmReset, Page::kConfirmStop, Page::kHelp}) {
    Keyboard keyboard;
    keyboard.page = page;
    EXPECT_THAT(text_of(lines_of(walking(), keyboard)), HasSubstr("SPACE"));
  }
  EXPECT_THAT(text_of(lines_of(walking(), {}, {}, {40, 10})), HasSubstr("SPACE"));
}

TEST(View, MenuKeepsTheChosenEntryInSight) {
  std::vector<std::string> many;
  for (int i = 0; i < 60; ++i) many.push_back("strategy-" + std::to_string(i));
  Keyboard keyboard;
  keyboard.page = Page::kStrategies;
  for (keyboard.menu_entry = 0; keyboard.menu_entry < many.size(); ++keyboard.menu_entry) {
    const auto lines = draw(walking(), keyboard, many, {}, kSmallest);
    EXPECT_TRUE(has_style(lines, Style::kSelected, " " + many[keyboard.menu_entry] + " "));
    EXPECT_LE(lines.size(), kSmallest.rows);
  }
}

TEST(View, MenuWithoutStrategiesSaysHowToGiveThem) {
  Keyboard keyboard;
  keyboard.page = Page::kStrategies;
  EXPECT_THAT(text_of(draw(walking(), keyboard, {}, {}, kSmallest)), HasSubstr("--strategies"));
}

/// The longest and worst that services may say.
Live overflowing() {
  Live live = walking();
  const std::string worst = std::string(300, 'x') + "\x1b[2J\n\t";
  live.where = live.tick_master = live.tick_master_says = live.reason = live.state = worst;
  live.phase = live.mode = worst;
  live.safe_stop = true;
  live.trial = live.tick = std::numeric_limits<std::uint32_t>::max();
  live.time_s = 1e300;
  live.bs_rad = live.as_rad = std::numeric_limits<double>::infinity();
  live.inputs.fill(std::numeric_limits<double>::quiet_NaN());
  live.position_rad.fill(-1e300);
  live.services.assign(40, {worst, worst, Concern::kFault, worst});
  live.refused.assign(40, {worst, std::numeric_limits<std::uint64_t>::max()});
  return live;
}

TEST(View, StaysInsideTheTerminalAndHarmless) {
  for (const Size size : {Size{0, 0}, {1, 1}, {79, 24}, {80, 24}, {81, 23}, {200, 60}}) {
    for (const Page page : {Page::kMain, Page::kStrategies, Page::kConfirmReset, Page::kHelp}) {
      Keyboard keyboard;
      keyboard.page = page;
      const auto lines = draw(overflowing(), keyboard, kStrategies,
                              {std::string(500, '\n'), Concern::kFault}, size);
      EXPECT_LE(lines.size(), size.rows);
      for (const Line& line : lines) {
        const std::string text = plain(line);
        EXPECT_LE(width(text), size.columns);
        EXPECT_TRUE(std::none_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
      }
    }
  }
}

TEST(View, NeedsAllOfTheSmallestTerminalOnly) {
  for (const Page page : {Page::kMain, Page::kConfirmReset, Page::kHelp}) {
    Keyboard keyboard;
    keyboard.page = page;
    const auto all = lines_of(walking(), keyboard, {}, {500, 500});
    const auto smallest = lines_of(walking(), keyboard);
    EXPECT_EQ(text_of(all), text_of(smallest)) << "nothing is cut";
  }
}

TEST(View, SaysWhatATooSmallTerminalLacks) {
  EXPECT_THAT(text_of(lines_of(walking(), {}, {}, {70, 24})), HasSubstr("80 x 24"));
  EXPECT_EQ(too_small({70, 20}), "needs a terminal of 80 x 24, this one has 70 x 20");
}

}  // namespace
}  // namespace scarab::drive
