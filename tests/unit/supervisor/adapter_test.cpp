#include "services/supervisor/adapter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "common/bus/error.hpp"
#include "common/robot/joints.hpp"

namespace scarab::supervisor {
namespace {

using Command = OperatorWord::Command;

TEST(OperatorAdapter, WordsSurviveTheBus) {
  OperatorWord word;
  word.mode = Mode::kHardPush;
  word.inputs = {1, -0.25, 0, 0.1};
  word.strategy = "soft+hard";
  word.reason = "to the window";
  for (const Command command :
       {Command::kAutomatic, Command::kStrategy, Command::kMode, Command::kInputs}) {
    word.command = command;
    scarab_Operator said{};
    fill(said, word);
    const auto heard = to_word(said);
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->command, command);
    EXPECT_EQ(heard->mode, word.mode);
    EXPECT_EQ(heard->inputs, word.inputs);
    EXPECT_EQ(heard->strategy, word.strategy);
    EXPECT_EQ(heard->reason, word.reason);
  }
}

TEST(OperatorAdapter, CommandsOfTheTickMasterAreNoWordsToTheSupervisor) {
  for (int command = scarab_OPERATOR_START; command <= scarab_OPERATOR_RESET; ++command) {
    scarab_Operator said{};
    said.command = static_cast<scarab_OperatorCommand>(command);
    EXPECT_FALSE(to_word(said)) << command;
  }
}

TEST(OperatorAdapter, CutsAReasonButNoName) {
  OperatorWord word;
  word.reason = std::string(500, 'x');
  scarab_Operator said{};
  fill(said, word);
  EXPECT_EQ(to_word(said)->reason.size(), sizeof said.reason - 1);
  word.strategy = std::string(64, 'x');  // half a name would be another strategy
  EXPECT_THROW(fill(said, word), bus::Error);
}

TEST(PerceptionAdapter, KeepsThePhaseAndBlindsWhatIsNotMeasured) {
  scarab_RobotState state{};
  state.header.tick = 7;
  state.inclination_rad[1] = 0.2;
  for (int phase = scarab_PHASE_RUNNING; phase <= scarab_PHASE_FAILED; ++phase) {
    state.phase = static_cast<scarab_TrialPhase>(phase);
    EXPECT_EQ(static_cast<int>(to_perception(state).phase), phase);
  }
  EXPECT_TRUE(std::isnan(to_perception(state).pitch_rad));
  state.imu_source = scarab_SOURCE_MEASURED;
  EXPECT_EQ(to_perception(state).pitch_rad, 0.2);
  EXPECT_EQ(to_perception(state).tick, 7U);
  EXPECT_TRUE(std::isnan(to_perception(state).front_f_rad[0]));
  const auto left = robot::joint_slot(robot::Leg::kL0, robot::LegJoint::kFemurTibia);
  state.position_source[left] = scarab_SOURCE_COMMANDED;
  state.position_rad[left] = 1.01;
  EXPECT_EQ(to_perception(state).front_f_rad[0], 1.01);
}

TEST(PerceptionAdapter, OnlyWhatBothFrontLegsMeasureIsMeasured) {
  scarab_RobotState state{};
  const auto left = robot::joint_slot(robot::Leg::kL0, robot::LegJoint::kFemurTibia);
  const auto right = robot::joint_slot(robot::Leg::kR0, robot::LegJoint::kFemurTibia);
  const auto measured = [&state] { return to_perception(state).measured; };
  EXPECT_FALSE(measured().front_angle || measured().supply_current || measured().foot_force);
  state.position_source[left] = scarab_SOURCE_MEASURED;
  state.position_source[right] = scarab_SOURCE_COMMANDED;
  EXPECT_FALSE(measured().front_angle) << "what is commanded tells of no load";
  state.position_source[right] = scarab_SOURCE_MEASURED;
  EXPECT_TRUE(measured().front_angle);
  state.foot_force_source[robot::leg_slot(robot::Leg::kL0)] = scarab_SOURCE_MEASURED;
  EXPECT_FALSE(measured().foot_force);
  state.foot_force_source[robot::leg_slot(robot::Leg::kR0)] = scarab_SOURCE_MEASURED;
  EXPECT_TRUE(measured().foot_force);
  state.supply_current_source = scarab_SOURCE_MEASURED;
  EXPECT_TRUE(measured().supply_current);
}

TEST(PerceptionAdapter, TakesCurrentAndFrontFeet) {
  scarab_RobotState state{};
  EXPECT_TRUE(std::isnan(to_perception(state).supply_current_a));
  EXPECT_TRUE(std::isnan(to_perception(state).front_foot_n[0]));
  state.supply_current_source = scarab_SOURCE_MEASURED;
  state.supply_current_a = 7.5;
  for (const auto leg : robot::kLegs) {
    state.foot_force_source[robot::leg_slot(leg)] = scarab_SOURCE_MEASURED;
    state.foot_force_n[robot::leg_slot(leg)] = 10 + static_cast<double>(robot::leg_slot(leg));
  }
  EXPECT_EQ(to_perception(state).supply_current_a, 7.5);
  EXPECT_EQ(to_perception(state).front_foot_n, (std::array<double, 2>{10, 13}));
}

TEST(BehaviourAdapter, TellsTheTrigger) {
  Decision decision;
  decision.trigger = Trigger::kSupplyCurrent;
  decision.trigger_value = 7.25;
  decision.trigger_threshold = 8.9;
  scarab_Behaviour behaviour{};
  fill(behaviour, decision);
  EXPECT_EQ(behaviour.trigger, scarab_TRIGGER_SUPPLY_CURRENT);
  EXPECT_EQ(behaviour.trigger_value, 7.25);
  EXPECT_EQ(behaviour.trigger_threshold, 8.9);
}

}  // namespace
}  // namespace scarab::supervisor
