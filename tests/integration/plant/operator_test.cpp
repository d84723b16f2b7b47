#include "tests/integration/plant/fixture.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

/// What a person says with scarab-operator, on a plant in the middle of a trial.
class Operator : public PlantProcess {
 protected:
  static int say(const std::string& command, const std::string& reason = "") {
    Arguments arguments = {program("scarab-operator"), "--tag", test_tag(), command};
    if (!reason.empty()) arguments.insert(arguments.end(), {"--reason", reason});
    return test::run(arguments).exit_code;
  }
  /// Answers until the plant says it is paused; the tick it stands before.
  std::optional<std::uint32_t> answer_until_paused(std::uint32_t tick) {
    const bool paused = eventually([&] {
      for (; ends_.states().count(1, tick) > 0; ++tick) {
        ends_.answer(*ends_.states().await(1, tick));
      }
      return status_.await_message(self_, "paused by the operator", std::chrono::milliseconds(1))
          .has_value();
    });
    if (!paused) return std::nullopt;
    return tick;
  }
};

TEST_F(Operator, PauseHoldsStepLetsOneTickThroughStartGoesOn) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 4));
  ASSERT_EQ(say("pause"), 0);
  const auto next = answer_until_paused(5);
  ASSERT_TRUE(next) << child_.err();
  ASSERT_EQ(ends_.states().count(1, *next), 0U);

  ASSERT_EQ(say("step"), 0);
  auto state = ends_.states().await(1, *next);
  ASSERT_TRUE(state) << child_.err();
  ends_.answer(*state);
  EXPECT_FALSE(ends_.states().await(1, *next + 1, std::chrono::milliseconds(300)));

  ASSERT_EQ(say("start"), 0);
  EXPECT_TRUE(ends_.run(1, *next + 1, *next + 10)) << child_.err();
  EXPECT_TRUE(healthy());
}

TEST_F(Operator, StopBeforeTheFirstTrialIsForNobody) {
  ASSERT_EQ(say("stop", "too early"), 0);
  ASSERT_TRUE(begin()) << child_.err();
  EXPECT_TRUE(ends_.run(1, 0, 4)) << child_.err();
  EXPECT_TRUE(healthy());
}

TEST_F(Operator, StopEndsTheTrialWithTheReason) {
  ASSERT_TRUE(begin());
  const auto state = ends_.run(1, 0, 4);
  ASSERT_TRUE(state);
  ASSERT_EQ(say("stop", "lunch"), 0);
  ends_.answer(*state);
  const auto verdict = world_.await(1);
  ASSERT_TRUE(verdict) << child_.err();
  EXPECT_EQ(verdict->verdict, scarab_VERDICT_FAILURE);
  EXPECT_EQ(verdict->reason, "operator stop: lunch");
}

TEST_F(Operator, StopEndsAPausedTrial) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 4));
  ASSERT_EQ(say("pause"), 0);
  ASSERT_TRUE(answer_until_paused(5));
  ASSERT_EQ(say("stop"), 0);
  const auto verdict = world_.await(1);
  ASSERT_TRUE(verdict) << child_.err();
  EXPECT_THAT(verdict->reason, HasSubstr("operator stop"));
}

TEST_F(Operator, EmergencyStopHoldsTheRobotUntilReset) {
  ASSERT_TRUE(begin());
  const auto state = ends_.run(1, 0, 4);
  ASSERT_TRUE(state);
  ASSERT_EQ(say("emergency-stop", "smoke"), 0);
  const auto report = status_.await_message(self_, "safe stop: operator emergency stop: smoke");
  ASSERT_TRUE(report) << child_.err();
  EXPECT_EQ(report->health, scarab_HEALTH_DEGRADED);
  EXPECT_TRUE(counted("safe_stops", 1));

  // Commands to move on are taken but not applied.
  auto held = *state;
  for (std::uint32_t tick = 5; tick < 25; ++tick) {
    const auto now = ends_.states().await(1, tick);
    ASSERT_TRUE(now) << child_.err();
    if (tick > 5) {
      EXPECT_EQ(now->phase, scarab_PHASE_SAFE_STOP) << "tick " << tick;
    }
    auto command = ChainEnds::command_for(*now);
    for (double& angle : command.position_rad) angle += 0.3;
    ends_.behave(*now);
    ends_.command(command);
    held = *now;
  }
  for (std::size_t joint = 0; joint < std::size(held.position_rad); ++joint) {
    EXPECT_NEAR(held.position_rad[joint], state->position_rad[joint], 0.1) << "joint " << joint;
  }
  EXPECT_TRUE(counted("commands_refused_safe_stop", 20));
}

TEST_F(Operator, ResetHomesTheRobotBeforeCommandsCountAgain) {
  constexpr std::size_t kFreeJoint = 1;  // T of a middle leg, whose foot no ground holds
  const auto start = begin();
  ASSERT_TRUE(start);
  // Away from the start pose, as fast as the joints go.
  std::optional<scarab_RobotState> state = start;
  for (std::uint32_t tick = 0; tick < 5; ++tick) {
    auto command = ChainEnds::command_for(*start);
    command.header = state->header;
    for (std::size_t leg = 0; leg < 6; ++leg) command.position_rad[leg] += 0.3;
    ends_.behave(*state);
    ends_.command(command);
    state = ends_.states().await(1, tick + 1);
    ASSERT_TRUE(state) << child_.err();
  }
  const auto away = state->position_rad[kFreeJoint] - start->position_rad[kFreeJoint];
  ASSERT_GT(away, 0.2);
  ASSERT_EQ(say("emergency-stop", "smoke"), 0);
  ASSERT_TRUE(status_.await_message(self_, "safe stop"));
  ASSERT_EQ(say("reset"), 0);
  ASSERT_TRUE(status_.await_message(self_, "homing")) << child_.err();

  unsigned homing = 0;
  double fastest_rad = 0;
  for (std::uint32_t tick = 5; state->phase != scarab_PHASE_RUNNING || tick < 8; ++tick) {
    ASSERT_LT(tick, 100U) << child_.err();
    ends_.answer(*state);  // stay: were it to count, the robot would not come home
    const auto next = ends_.states().await(1, tick + 1);
    ASSERT_TRUE(next) << child_.err();
    if (next->phase == scarab_PHASE_HOMING) {
      ++homing;
      fastest_rad = std::max(
          fastest_rad, std::abs(next->position_rad[kFreeJoint] - state->position_rad[kFreeJoint]));
    }
    state = next;
  }
  EXPECT_GE(homing, 3U);
  EXPECT_LT(fastest_rad, 0.1) << "0.5 rad/s for a tick, and the legs' compliance";
  EXPECT_NEAR(state->position_rad[kFreeJoint], start->position_rad[kFreeJoint], 0.1)
      << "servos give";
  EXPECT_TRUE(healthy());
}

TEST_F(Operator, EmergencyStopWithoutATrialHoldsTheNextOne) {
  ASSERT_TRUE(eventually([&] { return world_.matched(); })) << child_.err();
  ASSERT_EQ(say("emergency-stop", "hands in the way"), 0);
  ASSERT_TRUE(status_.await_message(self_, "hands in the way"));
  const auto state = begin();
  ASSERT_TRUE(state);
  EXPECT_EQ(state->phase, scarab_PHASE_SAFE_STOP);
}

TEST_F(Operator, NobodyListeningIsAFailure) {
  const auto result =
      test::run({program("scarab-operator"), "--tag", test_tag() + "-elsewhere", "pause"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("nobody listens on scarab/operator"));
}

}  // namespace
}  // namespace scarab::test
