#include "services/supervisor/core/obstacle_trigger.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "common/config/error.hpp"
#include "services/supervisor/config.hpp"
#include "tests/unit/supervisor/scripted_robot.hpp"

// Which signal switches from mode 1 to mode 2, and when.
namespace scarab::supervisor {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kBlockedRad = 1.013 - 0.1;
constexpr Measured kNoAngles{false, true, true};
constexpr Measured kFeetOnly{false, false, true};
constexpr Measured kNothing{};

/// Numbers to calculate with: current above 8 A, feet above 12 N; each preferred in this order.
SupervisorConfig three_triggers() {
  SupervisorConfig config = f2_config();
  config.supply_current = {5, 3, 3, 30};
  config.foot_force = {9, 3, 2, 40};
  config.strategies["soft+hard"].obstacle = {Trigger::kFrontAngle, Trigger::kSupplyCurrent,
                                             Trigger::kFootForce};
  return config;
}

/// In mode 1 with the object rolling freely: no signal says otherwise.
ScriptedRobot pushing(const Measured& measured, const SupervisorConfig& config = three_triggers()) {
  ScriptedRobot robot("soft+hard", config);
  robot.measured = measured;
  robot.supply_current_a = 5.5;
  robot.front_foot_n = 9.5;
  robot.pitch_rad = 0.18;
  robot.until(State::kMode1);
  EXPECT_EQ(robot.ticks(60).state, State::kMode1);
  return robot;
}

TEST(ObstacleTrigger, IsTheFirstOfTheListThatIsMeasured) {
  const std::vector<Trigger> all = {Trigger::kFrontAngle, Trigger::kSupplyCurrent,
                                    Trigger::kFootForce};
  EXPECT_EQ(first_measured(all, {true, true, true}), Trigger::kFrontAngle);
  EXPECT_EQ(first_measured(all, kNoAngles), Trigger::kSupplyCurrent);
  EXPECT_EQ(first_measured(all, kFeetOnly), Trigger::kFootForce);
  EXPECT_EQ(first_measured(all, kNothing), Trigger::kNone);
  EXPECT_EQ(first_measured({}, {true, true, true}), Trigger::kNone);
  EXPECT_EQ(first_measured({Trigger::kFootForce, Trigger::kFrontAngle}, {true, true, true}),
            Trigger::kFootForce)
      << "the list's order counts";
  EXPECT_EQ(first_measured({Trigger::kFrontAngle}, kNoAngles), Trigger::kNone);
}

TEST(ObstacleTrigger, EachSwitchesByItsOwnSignalAndNoOther) {
  for (const auto& [measured, trigger] :
       {std::pair{Measured{true, true, true}, Trigger::kFrontAngle},
        {kNoAngles, Trigger::kSupplyCurrent},
        {kFeetOnly, Trigger::kFootForce}}) {
    ScriptedRobot robot = pushing(measured);
    if (trigger != Trigger::kFrontAngle) robot.front_f_rad = kBlockedRad;
    if (trigger != Trigger::kSupplyCurrent) robot.supply_current_a = 12;
    if (trigger != Trigger::kFootForce) robot.front_foot_n = 20;
    const Decision others = robot.ticks(100);
    EXPECT_EQ(others.state, State::kMode1) << name(trigger);
    EXPECT_EQ(others.trigger, trigger);
    robot.front_f_rad = kBlockedRad;
    robot.supply_current_a = 12;
    robot.front_foot_n = 20;
    EXPECT_EQ(robot.until(State::kMode2).state, State::kMode2) << name(trigger);
  }
}

TEST(ObstacleTrigger, SaysWhatItSawAndWhy) {
  ScriptedRobot robot = pushing(kNoAngles);
  robot.supply_current_a = 10;
  const Decision decision = robot.until(State::kMode2);
  EXPECT_EQ(decision.trigger, Trigger::kSupplyCurrent);
  EXPECT_DOUBLE_EQ(decision.trigger_threshold, 8);
  EXPECT_GT(decision.trigger_value, 8);
  EXPECT_LT(decision.trigger_value, 10) << "the mean of a whole period";
  EXPECT_THAT(reason(decision),
              MatchesRegex("supply current [89]\\.[0-9]+ > 8\\.000 A for 3 ticks"));
  EXPECT_DOUBLE_EQ(decision.as_threshold_rad, 1.013 - 0.062) << "AS is reported all the same";

  ScriptedRobot feet = pushing(kFeetOnly);
  feet.front_foot_n = 15;
  EXPECT_THAT(reason(feet.until(State::kMode2)),
              MatchesRegex("front feet 1[23]\\.[0-9]+ > 12\\.000 N for 2 ticks"));
}

TEST(ObstacleTrigger, DoesNotSwitchAtTheThresholdItself) {
  ScriptedRobot robot = pushing(kNoAngles);
  robot.supply_current_a = 8;
  EXPECT_EQ(robot.ticks(200).state, State::kMode1);
}

TEST(ObstacleTrigger, IsArmedAfterItsOwnTime) {
  SupervisorConfig config = three_triggers();
  for (const auto& [measured, arm, confirm] :
       {std::tuple{kNoAngles, 30U, 3U}, std::tuple{kFeetOnly, 40U, 2U}}) {
    ScriptedRobot robot("soft+hard", config);
    robot.measured = measured;
    robot.supply_current_a = robot.front_foot_n = 50;
    robot.pitch_rad = 0.18;
    const std::uint32_t entered = robot.until(State::kMode1).entered_tick;
    EXPECT_EQ(robot.until(State::kMode2).entered_tick, entered + arm + confirm - 1);
  }
}

TEST(ObstacleTrigger, IsChosenAtTheFirstRunningTickForTheWholeTrial) {
  ScriptedRobot robot("soft+hard", three_triggers());
  robot.phase = Phase::kHoming;
  robot.measured = kNothing;
  EXPECT_EQ(robot.ticks(5).trigger, Trigger::kNone) << "not before the trial runs";
  EXPECT_EQ(robot.machine.complaint(robot.state), "");
  robot.phase = Phase::kRunning;
  robot.measured = kNoAngles;
  EXPECT_EQ(robot.tick().trigger, Trigger::kSupplyCurrent);
  robot.measured = {true, true, true};
  EXPECT_EQ(robot.ticks(10).trigger, Trigger::kSupplyCurrent);
  robot.measured = kNothing;  // lost on the way
  EXPECT_EQ(robot.ticks(10).trigger, Trigger::kSupplyCurrent);
}

TEST(ObstacleTrigger, ASafeStopChangesNothing) {
  ScriptedRobot robot = pushing(kNoAngles);
  robot.phase = Phase::kSafeStop;
  robot.measured = {true, true, true};
  robot.ticks(3);
  robot.phase = Phase::kRunning;
  EXPECT_EQ(robot.tick().trigger, Trigger::kSupplyCurrent);
}

TEST(ObstacleTrigger, WithoutOneThereIsNoMode2AndAComplaint) {
  ScriptedRobot robot = pushing(kNothing);
  robot.front_f_rad = kBlockedRad;
  robot.supply_current_a = robot.front_foot_n = 100;
  const Decision decision = robot.ticks(300);
  EXPECT_EQ(decision.state, State::kMode1);
  EXPECT_EQ(decision.trigger, Trigger::kNone);
  EXPECT_EQ(decision.trigger_value, 0);
  EXPECT_THAT(robot.machine.complaint(robot.state),
              HasSubstr("(front_angle, supply_current, foot_force)"));
}

TEST(ObstacleTrigger, AStrategyWithoutMode2NeedsNone) {
  ScriptedRobot robot("soft", three_triggers());
  robot.measured = kNothing;
  EXPECT_EQ(robot.tick().trigger, Trigger::kNone);
  EXPECT_EQ(robot.machine.complaint(robot.state), "");
}

TEST(ObstacleTrigger, AnotherStrategyOfTheOperatorsChoosesAnew) {
  SupervisorConfig config = three_triggers();
  config.strategies["boxing+hard"].obstacle = {Trigger::kFootForce};
  config.strategies["stationary+hard"].obstacle = {Trigger::kFrontAngle};
  ScriptedRobot robot("soft+hard", config);
  robot.measured = kNoAngles;
  robot.tick();
  ASSERT_EQ(robot.tell(strategy_word("boxing+hard")), "");
  EXPECT_EQ(robot.tick().trigger, Trigger::kFootForce);
  ASSERT_EQ(robot.tell(strategy_word("stationary+hard")), "");
  EXPECT_EQ(robot.tick().trigger, Trigger::kNone) << "of what was measured when the trial began";
  EXPECT_NE(robot.machine.complaint(robot.state), "");
  ASSERT_EQ(robot.tell(mode_word(Mode::kForward)), "");
  robot.tick();
  EXPECT_EQ(robot.machine.complaint(robot.state), "") << "nobody waits for a switch";
}

TEST(ObstacleTrigger, PassesOverReadingsThatAreNotFinite) {
  ScriptedRobot robot = pushing(kNoAngles);
  robot.supply_current_a = kNan;
  const Decision blind = robot.ticks(100);
  EXPECT_EQ(blind.state, State::kMode1);
  EXPECT_DOUBLE_EQ(blind.trigger_value, 5.5);
  robot.supply_current_a = 10;
  EXPECT_EQ(robot.until(State::kMode2).state, State::kMode2);
}

/// A file of the machine's memory is all that a restarted supervisor needs.
TEST(ObstacleTrigger, GoesOnFromACopiedStateBitByBit) {
  ScriptedRobot whole = pushing(kNoAngles);
  ScriptedRobot fresh("soft+hard", three_triggers());
  std::memcpy(static_cast<void*>(&fresh.state), &whole.state, sizeof(MachineState));
  Perception blocked;
  blocked.pitch_rad = 0.18;
  blocked.front_f_rad = {1.013, 1.013};
  blocked.supply_current_a = 10;
  for (std::uint32_t tick = whole.next_tick(); tick < whole.next_tick() + 20; ++tick) {
    blocked.tick = tick;
    const Decision a = whole.machine.step(whole.state, blocked);
    const Decision b = fresh.machine.step(fresh.state, blocked);
    ASSERT_EQ(std::memcmp(&whole.state, &fresh.state, sizeof(MachineState)), 0) << tick;
    ASSERT_EQ(a.reason, b.reason);
    ASSERT_EQ(a.trigger_value, b.trigger_value);
  }
  EXPECT_EQ(fresh.state.state, State::kMode2);
}

TEST(ObstacleTrigger, ParametersOutOfRangeAreRefused) {
  const auto refused = [](const auto& set) {
    SupervisorConfig config = three_triggers();
    set(config);
    EXPECT_THROW(BehaviourMachine(config, find_strategy(config, "soft")), std::invalid_argument);
  };
  refused([](SupervisorConfig& c) { c.supply_current.rise_a = kNan; });
  refused([](SupervisorConfig& c) { c.supply_current.reference_a = kNan; });
  refused([](SupervisorConfig& c) { c.supply_current.confirm_ticks = 0; });
  refused([](SupervisorConfig& c) { c.foot_force.reference_n = kNan; });
  refused([](SupervisorConfig& c) { c.foot_force.rise_n = kNan; });
  refused([](SupervisorConfig& c) { c.foot_force.confirm_ticks = 0; });
}

/// Why the shipped file is refused with this list in place of soft+hard's; empty: it is not.
std::string refusal_of_list(const std::string& obstacle) {
  std::ostringstream shipped;
  shipped << std::ifstream(SCARAB_SOURCE_DIR "/config/supervisor/beetle.yaml").rdbuf();
  std::string text = shipped.str();
  const std::string key = "obstacle: [";
  const std::size_t begin = text.find(key, text.find("soft+hard: ")) + key.size() - 1;
  text.replace(begin, text.find(']', begin) + 1 - begin, obstacle);
  try {
    (void)load_config_text("mine.yaml", text);
    return "";
  } catch (const config::Error& error) {
    return error.what();
  }
}

TEST(ObstacleTrigger, ListsAreCheckedWhenTheFileIsRead) {
  EXPECT_EQ(refusal_of_list("[foot_force, front_angle]"), "");
  EXPECT_THAT(refusal_of_list("[]"), HasSubstr("two pushing modes need a signal"));
  EXPECT_THAT(refusal_of_list("[none]"), HasSubstr("none"));
  EXPECT_THAT(refusal_of_list("[front_angel]"), HasSubstr("front_angle"));
}

TEST(ObstacleTrigger, ShippedStrategiesPreferTheAngle) {
  for (const auto& [strategy_name, strategy] : shipped_config().strategies) {
    EXPECT_EQ(strategy.obstacle.front(), Trigger::kFrontAngle) << strategy_name;
    if (strategy.push.size() == 2) {
      EXPECT_EQ(first_measured(strategy.obstacle, kNoAngles), Trigger::kSupplyCurrent)
          << strategy_name << ": AMOS II has no joint angles";
    }
  }
}

}  // namespace
}  // namespace scarab::supervisor
