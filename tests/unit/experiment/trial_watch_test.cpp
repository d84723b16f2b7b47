#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "common/bus/sample_fields.hpp"
#include "services/experiment/adapter.hpp"

namespace scarab::experiment {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;

constexpr std::uint32_t kTrial = 4;
constexpr std::int64_t kTickNs = 100'000'000;

scarab_Header header_of(std::uint32_t trial, std::uint32_t tick) {
  return {trial, tick, tick * kTickNs, 0};
}

scarab_Behaviour behaviour_of(std::uint32_t tick, scarab_BehaviourState state,
                              const std::string& reason = "", std::uint32_t trial = kTrial) {
  scarab_Behaviour behaviour{};
  behaviour.header = header_of(trial, tick);
  behaviour.state = state;
  bus::assign(behaviour.reason, reason);
  return behaviour;
}

scarab_WorldState world_of(std::uint32_t tick, scarab_Verdict verdict = scarab_VERDICT_OPEN,
                           const std::string& reason = "", std::uint32_t trial = kTrial) {
  scarab_WorldState world{};
  world.header = header_of(trial, tick);
  world.object_travel_m = 0.01 * tick;
  world.trunk.orientation_wxyz[0] = 1;
  world.verdict = verdict;
  bus::assign(world.verdict_reason, reason);
  return world;
}

class TrialWatchTest : public testing::Test {
 protected:
  static scarab_Trial trial() {
    scarab_Trial trial{};
    trial.header.trial = kTrial;
    bus::assign(trial.strategy, "boxing+hard");
    trial.obstacle_height_m = 0.08;
    trial.seed = 11;
    return trial;
  }
  TrialWatch watch_{trial()};
};

TEST_F(TrialWatchTest, OutcomeNamesItsTrial) {
  const auto& outcome = watch_.outcome();
  EXPECT_EQ(outcome.number, kTrial);
  EXPECT_EQ(outcome.strategy, "boxing+hard");
  EXPECT_EQ(outcome.height_m, 0.08);
  EXPECT_EQ(outcome.seed, 11U);
  EXPECT_FALSE(watch_.ended());
}

TEST_F(TrialWatchTest, NotesEachChangeOfBehaviourOnce) {
  watch_.see(behaviour_of(0, scarab_BEHAVIOUR_APPROACH, "trial starts"));
  watch_.see(behaviour_of(1, scarab_BEHAVIOUR_APPROACH, "trial starts"));
  watch_.see(behaviour_of(23, scarab_BEHAVIOUR_CLIMB, "BS"));
  watch_.see(behaviour_of(23, scarab_BEHAVIOUR_CLIMB, "BS"));  // an answer said again
  watch_.see(behaviour_of(30, scarab_BEHAVIOUR_MODE_1, "settled"));
  const auto change = [](double time_s, const std::string& state, const std::string& reason) {
    return AllOf(Field(&BehaviourChange::time_s, testing::DoubleEq(time_s)),
                 Field(&BehaviourChange::state, state), Field(&BehaviourChange::reason, reason));
  };
  EXPECT_THAT(watch_.outcome().changes,
              ElementsAre(change(0, "approach", "trial starts"), change(2.3, "climb", "BS"),
                          change(3.0, "mode 1", "settled")));
  EXPECT_EQ(watch_.outcome().end.state, "mode 1");
}

TEST_F(TrialWatchTest, OtherTrialsAreNotSeen) {
  watch_.see(behaviour_of(5, scarab_BEHAVIOUR_DONE, "", kTrial - 1));
  watch_.see(world_of(5, scarab_VERDICT_FAILURE, "old", kTrial - 1));
  watch_.see(world_of(5, scarab_VERDICT_FAILURE, "new", kTrial + 1));
  EXPECT_FALSE(watch_.ended());
  EXPECT_TRUE(watch_.outcome().changes.empty());
  EXPECT_EQ(watch_.last_tick(), 0U);
}

TEST_F(TrialWatchTest, FollowsProgress) {
  watch_.see(world_of(0));
  watch_.see(world_of(7));
  EXPECT_DOUBLE_EQ(watch_.outcome().end.time_s, 0.7);
  EXPECT_DOUBLE_EQ(watch_.outcome().end.travel_m, 0.07);
  EXPECT_GE(watch_.outcome().end.wall_s, 0);
  EXPECT_EQ(watch_.last_tick(), 7U);
}

TEST_F(TrialWatchTest, TheFirstVerdictIsTheOutcome) {
  watch_.see(world_of(100));
  watch_.see(world_of(101, scarab_VERDICT_SUCCESS, "the object is across"));
  EXPECT_TRUE(watch_.ended());
  watch_.see(world_of(102, scarab_VERDICT_FAILURE, "too late"));
  EXPECT_TRUE(watch_.outcome().success);
  EXPECT_EQ(watch_.outcome().reason, "the object is across");
  EXPECT_EQ(watch_.last_tick(), 101U);
}

TEST_F(TrialWatchTest, CanBeEndedFromHere) {
  watch_.see(world_of(3));
  watch_.fail("premotor/0: cannot go on");
  EXPECT_TRUE(watch_.ended());
  EXPECT_FALSE(watch_.outcome().success);
  EXPECT_EQ(watch_.outcome().reason, "premotor/0: cannot go on");
}

/// The trunk at (x, y) with this heading, the object at `object_y`.
scarab_WorldState world_at(std::uint32_t tick, double x, double y, double heading_rad,
                           double object_y = 0) {
  auto world = world_of(tick);
  world.trunk.position_m[0] = x;
  world.trunk.position_m[1] = y;
  world.trunk.position_m[2] = 0.1 * tick;  // up and down is no travel
  world.trunk.orientation_wxyz[0] = std::cos(heading_rad / 2);
  world.trunk.orientation_wxyz[3] = std::sin(heading_rad / 2);
  world.object.position_m[1] = object_y;
  return world;
}

TEST_F(TrialWatchTest, MeasuresFromTheFirstSampleToTheLast) {
  watch_.see(world_at(0, 1, 2, 0.1, 0.02));
  watch_.see(world_at(1, 0, 0, -0.3, 0.5));
  watch_.see(world_at(2, -2, -2, 0.2, -0.01));
  const auto& measures = watch_.outcome().measures;
  EXPECT_DOUBLE_EQ(measures.object_travel_m, 0.02);
  EXPECT_DOUBLE_EQ(measures.object_sideways_m, -0.03);
  EXPECT_DOUBLE_EQ(measures.trunk_travel_m, 5);
  EXPECT_NEAR(measures.heading_rad, 0.1, 1e-12);
  EXPECT_NEAR(measures.heading_max_rad, 0.4, 1e-12);
  EXPECT_EQ(watch_.outcome().missed, "");
}

TEST_F(TrialWatchTest, HeadingGoesOnThroughPi) {
  for (std::uint32_t tick = 0; tick < 80; ++tick) watch_.see(world_at(tick, 0, 0, 0.1 * tick));
  EXPECT_NEAR(watch_.outcome().measures.heading_rad, 7.9, 1e-9);
  EXPECT_NEAR(watch_.outcome().measures.heading_max_rad, 7.9, 1e-9);
}

TEST_F(TrialWatchTest, NothingIsMeasuredAfterTheVerdict) {
  watch_.see(world_at(0, 0, 0, 0));
  auto last = world_at(1, 0, 3, 0);
  last.verdict = scarab_VERDICT_FAILURE;
  watch_.see(last);
  watch_.see(world_at(2, 0, 9, 1));
  EXPECT_DOUBLE_EQ(watch_.outcome().measures.trunk_travel_m, 3);
  EXPECT_EQ(watch_.outcome().end.time_s, 0.1);
}

TEST_F(TrialWatchTest, SaysWhenAStateWasFirstEntered) {
  watch_.see(behaviour_of(0, scarab_BEHAVIOUR_APPROACH));
  watch_.see(behaviour_of(1, scarab_BEHAVIOUR_CLIMB));
  watch_.see(behaviour_of(2, scarab_BEHAVIOUR_APPROACH));
  watch_.see(behaviour_of(3, scarab_BEHAVIOUR_CLIMB));
  watch_.see(behaviour_of(4, scarab_BEHAVIOUR_MODE_1));
  watch_.see(behaviour_of(5, scarab_BEHAVIOUR_FAILED));
  const auto& measures = watch_.outcome().measures;
  EXPECT_EQ(measures.climb_s, 0.1);
  EXPECT_EQ(measures.mode1_s, 0.4);
  EXPECT_EQ(measures.mode2_s, std::nullopt);
}

TEST_F(TrialWatchTest, AMissedFirstSampleIsNoticed) {
  watch_.see(world_of(1));
  watch_.see(world_of(2, scarab_VERDICT_SUCCESS));
  EXPECT_TRUE(watch_.ended());
  EXPECT_THAT(watch_.outcome().missed, testing::HasSubstr("world_state of 0.000 s"));
}

TEST_F(TrialWatchTest, AMissedChangeOfBehaviourIsNoticed) {
  watch_.see(behaviour_of(0, scarab_BEHAVIOUR_APPROACH));
  watch_.see(behaviour_of(2, scarab_BEHAVIOUR_APPROACH));  // there was no change meanwhile
  EXPECT_EQ(watch_.outcome().missed, "");
  auto climb = behaviour_of(4, scarab_BEHAVIOUR_CLIMB);
  climb.entered_tick = 3;
  watch_.see(climb);
  EXPECT_EQ(watch_.outcome().missed, "behaviour of tick 3 was missed");
}

TEST_F(TrialWatchTest, AStateHeardOfTooLateIsNoticed) {
  auto climb = behaviour_of(9, scarab_BEHAVIOUR_CLIMB);
  climb.entered_tick = 7;
  watch_.see(climb);
  EXPECT_EQ(watch_.outcome().missed, "behaviour of tick 0 was missed");
}

TEST_F(TrialWatchTest, AnAnswerSaidAgainIsNoGap) {
  for (const std::uint32_t tick : {0, 1, 2, 1, 2, 3}) {
    auto climb = behaviour_of(tick, scarab_BEHAVIOUR_CLIMB);
    climb.entered_tick = tick == 3 ? 3 : 0;
    watch_.see(climb);
  }
  EXPECT_EQ(watch_.outcome().missed, "");
}

TEST_F(TrialWatchTest, IsCompleteWithTheLastAnswer) {
  watch_.see(world_of(0));
  watch_.see(world_of(1, scarab_VERDICT_SUCCESS));
  EXPECT_FALSE(watch_.complete());
  watch_.see(behaviour_of(0, scarab_BEHAVIOUR_APPROACH));
  EXPECT_FALSE(watch_.complete());
  watch_.see(behaviour_of(1, scarab_BEHAVIOUR_DONE));
  EXPECT_TRUE(watch_.complete());
  EXPECT_TRUE(watch_.outcome().judged);
}

/// A robot's trial: the tick master ends it; whoever sees the world counts ticks on its own.
class RobotTrialTest : public TrialWatchTest {
 protected:
  static scarab_RobotState state_of(std::uint32_t tick,
                                    scarab_TrialPhase phase = scarab_PHASE_RUNNING) {
    scarab_RobotState state{};
    state.header = header_of(kTrial, tick);
    state.phase = phase;
    return state;
  }
  TrialWatch robot_{trial(), Judge::kTickMaster};
};

TEST_F(RobotTrialTest, EndsByThePhaseWithoutAnyWorld) {
  robot_.see(state_of(0));
  EXPECT_TRUE(robot_.began());
  robot_.see(state_of(8));
  EXPECT_DOUBLE_EQ(robot_.outcome().end.time_s, 0.8);
  robot_.see(state_of(9, scarab_PHASE_FAILED));
  EXPECT_TRUE(robot_.ended());
  EXPECT_EQ(robot_.last_tick(), 9U);
  EXPECT_TRUE(robot_.outcome().judged);
  EXPECT_FALSE(robot_.outcome().success);
  EXPECT_TRUE(robot_.wants_reason());
  robot_.explain("operator stop: lunch");
  EXPECT_EQ(robot_.outcome().reason, "operator stop: lunch");
  EXPECT_FALSE(robot_.wants_reason());
  EXPECT_FALSE(robot_.complete());
  robot_.see(behaviour_of(9, scarab_BEHAVIOUR_FAILED));
  EXPECT_TRUE(robot_.complete());
  EXPECT_EQ(robot_.outcome().missed, "");
}

TEST_F(RobotTrialTest, WhoSeesTheWorldMeasuresAndSaysWhy) {
  for (const std::uint32_t tick : {12, 13, 17}) robot_.see(world_of(tick));  // its own ticks
  EXPECT_FALSE(robot_.began()) << "the robot is on its way home";
  robot_.see(state_of(0));
  robot_.see(world_of(40, scarab_VERDICT_SUCCESS, "across"));
  EXPECT_FALSE(robot_.ended()) << "the tick master has not said so";
  robot_.see(world_of(41, scarab_VERDICT_SUCCESS, "across"));
  robot_.see(state_of(30, scarab_PHASE_SUCCEEDED));
  EXPECT_TRUE(robot_.ended());
  EXPECT_TRUE(robot_.outcome().success);
  EXPECT_EQ(robot_.outcome().reason, "across");
  EXPECT_EQ(robot_.last_tick(), 30U);
  EXPECT_DOUBLE_EQ(robot_.outcome().end.time_s, 3.0);
  EXPECT_DOUBLE_EQ(robot_.outcome().measures.object_travel_m, 0.40) << "up to the verdict";
  EXPECT_EQ(robot_.outcome().missed, "") << "its clock is not ours";
}

TEST_F(RobotTrialTest, AVerdictThatComesAfterThePhaseExplainsItStill) {
  robot_.see(state_of(30, scarab_PHASE_SUCCEEDED));
  robot_.see(world_of(40));
  EXPECT_TRUE(robot_.wants_reason());
  robot_.see(world_of(41, scarab_VERDICT_SUCCESS, "across"));
  EXPECT_EQ(robot_.outcome().reason, "across");
}

TEST_F(RobotTrialTest, AnotherVerdictThanTheTickMastersExplainsNothing) {
  robot_.see(world_of(40, scarab_VERDICT_SUCCESS, "across"));
  robot_.see(state_of(30, scarab_PHASE_FAILED));
  EXPECT_FALSE(robot_.outcome().success);
  EXPECT_TRUE(robot_.wants_reason());
}

TEST_F(RobotTrialTest, StatesAreNotNeededWhereTheRefereeJudges) {
  watch_.see(state_of(9, scarab_PHASE_FAILED));
  EXPECT_FALSE(watch_.ended());
  EXPECT_EQ(watch_.last_tick(), 0U);
}

TEST_F(TrialWatchTest, WhatWasEndedFromHereIsNotJudged) {
  watch_.fail("silence");
  EXPECT_FALSE(watch_.outcome().judged);
}

}  // namespace
}  // namespace scarab::experiment
