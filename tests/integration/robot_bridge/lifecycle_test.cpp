#include "tests/integration/robot_bridge/fixture.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

using Lifecycle = BridgeProcess;

TEST_F(Lifecycle, GoesFromADeviceThatIsNotThereToTheEnd) {
  start_bridge("loopback: {appears_after_s: 1.0}\n");
  const auto absent = await([](const Report& r) {
    return r.lifecycle == scarab_LIFECYCLE_UNCONFIGURED && r.health == scarab_HEALTH_WAITING;
  });
  ASSERT_TRUE(absent) << child_->err();
  EXPECT_THAT(absent->message, HasSubstr("waits for the robot at loopback"));
  EXPECT_THAT(absent->message, HasSubstr("not there, as configured"));

  ASSERT_TRUE(await([](const Report& r) { return r.lifecycle == scarab_LIFECYCLE_INACTIVE; }));
  // States are readable with motors off: where the robot really stands.
  ASSERT_TRUE(eventually([&] { return !sensors_.all().empty(); })) << child_->err();
  const scarab_RobotState idle = sensors_.all().front();
  EXPECT_EQ(idle.header.trial, 0U);
  EXPECT_TRUE(all_measured(idle));
  EXPECT_EQ(idle.position_rad[14], 0);
  EXPECT_EQ(counter("loopback_writes"), 0U);

  // The trial's first tick comes once the robot stands in its start pose.
  const auto first = begin();
  ASSERT_TRUE(first);
  for (std::size_t slot = 0; slot < 19; ++slot) {
    EXPECT_NEAR(first->position_rad[slot], start_pose_rad(slot), 0.01) << "slot " << slot;
  }
  EXPECT_EQ(first->phase, scarab_PHASE_RUNNING);
  EXPECT_EQ(first->header.sim_time_ns, 0);
  EXPECT_TRUE(await([](const Report& r) { return r.lifecycle == scarab_LIFECYCLE_ACTIVE; }));

  // On the way there each joint moved no faster than the homing allows, and nobody was asked.
  double earlier_rad = 0;
  bool homed = false;
  for (const auto& sample : sensors_.all()) {
    if (sample.phase != scarab_PHASE_HOMING) continue;
    homed = true;
    EXPECT_EQ(sample.header.sim_time_ns, 0);
    EXPECT_GE(sample.position_rad[14], earlier_rad - 1e-9);
    earlier_rad = sample.position_rad[14];
  }
  EXPECT_TRUE(homed);

  // The end: motors off, whatever the trial was doing.
  ASSERT_NO_FATAL_FAILURE(answer_ticks(5));
  EXPECT_EQ(child_->stop(), 0);
  EXPECT_THAT(child_->err(), HasSubstr("motors off"));
}

TEST_F(Lifecycle, ATrialEndsAtItsTimeLimitWhereNobodyJudges) {
  start_bridge("");
  ASSERT_TRUE(begin(1, 1.0));
  const auto last = answer_until(scarab_PHASE_SUCCEEDED);
  ASSERT_TRUE(last) << child_->err();
  EXPECT_EQ(last->header.tick, 10U);
  EXPECT_EQ(last->header.sim_time_ns, 1'000'000'000);
  EXPECT_TRUE(says("trial 1 ended: success: ran to the time limit of 1.0 s"));
  const auto report =
      await([](const Report& r) { return r.lifecycle == scarab_LIFECYCLE_INACTIVE; });
  ASSERT_TRUE(report);
  ASSERT_EQ(report->histograms.count("bus_exchange"), 1U);
  EXPECT_GE(report->histograms.at("bus_exchange").total(), 50U) << "five exchanges a tick";
  EXPECT_THAT(child_->err(), HasSubstr("motors off"));
}

TEST_F(Lifecycle, ATrialEndsWithTheVerdictOfWhoeverWatches) {
  bus::Participant watcher(test_options("tracking"));
  bus::Writer<scarab_WorldState> worlds(watcher, bus::kWorldState);
  start_bridge("");
  ASSERT_TRUE(begin());
  ASSERT_TRUE(eventually([&] { return !worlds.matched().empty(); }));
  scarab_WorldState world{};
  world.verdict = scarab_VERDICT_SUCCESS;
  bus::assign(world.verdict_reason, "of another trial");
  world.header.trial = 7;
  worlds.write(world);
  ASSERT_NO_FATAL_FAILURE(answer_ticks(3));
  bus::assign(world.verdict_reason, "the object is across");
  world.header.trial = 1;
  worlds.write(world);
  ASSERT_TRUE(answer_until(scarab_PHASE_SUCCEEDED)) << child_->err();
  EXPECT_TRUE(says("trial 1 ended: success: the object is across"));
}

TEST_F(Lifecycle, ARealRobotDoesNotRunInLockstep) {
  start_bridge("", {"--pace", "lockstep"});
  EXPECT_EQ(child_->wait(kPatience), 2);
  EXPECT_EQ(child_->err(),
            "scarab-robot-bridge: --pace: lockstep: a real robot waits for nobody; say realtime "
            "(see --help)\n");
}

}  // namespace
}  // namespace scarab::test
