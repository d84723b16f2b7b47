#include <limits>

#include "tests/integration/robot_bridge/fixture.hpp"

namespace scarab::test {
namespace {

constexpr std::size_t kJoint = 12;
constexpr double kStep_rad = 0.3;  // inside the joint's range, and inside a tick's window

/// Servos follow what the device is told, so where they are measured tells what reached it.
class Gate : public BridgeProcess {
 protected:
  void SetUp() override {
    start_bridge("");
    ASSERT_TRUE(begin());
  }

  static scarab_JointCommand step_for(const scarab_RobotState& state) {
    scarab_JointCommand command = ChainEnds::command_for(state);
    command.position_rad[kJoint] += kStep_rad;
    return command;
  }
  /// Answers one state with a spoilt step, which must be refused, and then properly.
  template <class Spoil>
  void send_spoilt(const Spoil& spoil) {
    ASSERT_TRUE(answer_until([&](const auto& state) {
      scarab_JointCommand bad = step_for(state);
      spoil(bad);
      ends_.command(bad);
      return true;
    })) << child_->err();
    ASSERT_NO_FATAL_FAILURE(answer_ticks(2));
  }
  std::optional<double> joint_rad() {
    const auto state = answer_until([](const auto&) { return true; });
    if (!state) return std::nullopt;
    return state->position_rad[kJoint];
  }
  bool counted(const std::string& name) {
    return await([&](const Report& r) {
             const auto entry = r.counters.find(name);
             return entry != r.counters.end() && entry->second == 1;
           })
        .has_value();
  }
};

TEST_F(Gate, NothingThatItRefusesReachesTheDevice) {
  const double home_rad = start_pose_rad(kJoint);
  send_spoilt(
      [](auto& command) { command.position_rad[3] = std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_TRUE(counted("commands_refused_finite"));
  EXPECT_TRUE(says("TR0 is not finite"));
  EXPECT_NEAR(joint_rad().value_or(0), home_rad, 1e-6);

  send_spoilt([](auto& command) { command.header.trial = 9; });
  EXPECT_TRUE(counted("commands_refused_trial"));
  EXPECT_NEAR(joint_rad().value_or(0), home_rad, 1e-6);

  send_spoilt([](auto& command) { command.header.tick += 5; });
  EXPECT_TRUE(counted("commands_refused_future"));
  EXPECT_NEAR(joint_rad().value_or(0), home_rad, 1e-6);

  // And what it does not refuse does.
  command_ = step_for;
  ASSERT_NO_FATAL_FAILURE(answer_ticks(1));
  command_ = ChainEnds::command_for;
  EXPECT_NEAR(joint_rad().value_or(0), home_rad + kStep_rad, 1e-6);
}

TEST_F(Gate, AnEmergencyStopHoldsAtOnceAndNothingIsWrittenUntilTheReset) {
  ASSERT_NO_FATAL_FAILURE(answer_ticks(3));
  tell(scarab_OPERATOR_EMERGENCY_STOP, "test");
  ASSERT_TRUE(answer_until(scarab_PHASE_SAFE_STOP)) << child_->err();
  EXPECT_TRUE(says("safe stop: operator emergency stop: test"));
  const auto stopped_rad = joint_rad();
  command_ = step_for;  // what comes meanwhile moves nothing
  const auto now = answer_until([](const auto&) { return true; });
  ASSERT_TRUE(now);
  const std::uint64_t written = counter("loopback_writes", now->header.tick);
  ASSERT_NO_FATAL_FAILURE(answer_ticks(5));
  EXPECT_EQ(joint_rad(), stopped_rad);
  EXPECT_EQ(counter("loopback_writes", now->header.tick + 5), written);

  command_ = ChainEnds::command_for;
  tell(scarab_OPERATOR_RESET);
  const auto again = answer_until(scarab_PHASE_RUNNING);
  ASSERT_TRUE(again) << child_->err();
  EXPECT_GT(counter("loopback_writes", again->header.tick), written);
}

/// Motors off is not active, in the middle of a trial, too.
TEST_F(BridgeProcess, AnEmergencyStopThatReleasesIsInactiveUntilTheReset) {
  start_bridge("safe_stop: release\n");
  ASSERT_TRUE(begin());
  ASSERT_NO_FATAL_FAILURE(answer_ticks(1));
  tell(scarab_OPERATOR_EMERGENCY_STOP, "test");
  ASSERT_TRUE(answer_until(scarab_PHASE_SAFE_STOP)) << child_->err();
  const auto stopped = await([](const Report& r) {
    return r.lifecycle == scarab_LIFECYCLE_INACTIVE && r.health == scarab_HEALTH_DEGRADED;
  });
  ASSERT_TRUE(stopped) << child_->err();
  tell(scarab_OPERATOR_RESET);
  ASSERT_TRUE(answer_until(scarab_PHASE_RUNNING)) << child_->err();
  EXPECT_TRUE(await([](const Report& r) { return r.lifecycle == scarab_LIFECYCLE_ACTIVE; }));
}

TEST_F(Gate, SilenceBringsTheSafeStop) {
  ASSERT_NO_FATAL_FAILURE(answer_ticks(3));
  ASSERT_TRUE(
      eventually([&] { return ends_.states().all().back().phase == scarab_PHASE_SAFE_STOP; }));
  EXPECT_TRUE(says("safe stop: no valid joint_command"));
}

}  // namespace
}  // namespace scarab::test
