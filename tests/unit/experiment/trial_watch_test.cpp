#include <gmock/gmock.h>

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

}  // namespace
}  // namespace scarab::experiment
