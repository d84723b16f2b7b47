#include "tools/drive/adapter.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "common/bus/sample_fields.hpp"

namespace scarab::drive {
namespace {

TEST(Adapter, TakesWhatTheRobotSays) {
  scarab_RobotState state{};
  state.header = {3, 42, 4'200'000'000, 1};
  state.phase = scarab_PHASE_HOMING;
  state.real_time = true;
  state.position_rad[18] = 0.05;
  state.position_source[18] = scarab_SOURCE_COMMANDED;
  Live live;
  see(live, state);
  EXPECT_EQ(live.trial, 3U);
  EXPECT_EQ(live.tick, 42U);
  EXPECT_DOUBLE_EQ(live.time_s, 4.2);
  EXPECT_TRUE(live.real_time);
  EXPECT_EQ(live.phase, "homing");
  EXPECT_TRUE(live.has_joint[18]) << "a commanded angle stands in for a measured one";
  EXPECT_FALSE(live.has_joint[0]);
  EXPECT_EQ(live.position_rad[18], 0.05);
}

TEST(Adapter, TakesWhatTheSupervisorSays) {
  scarab_Behaviour behaviour{};
  behaviour.mode = scarab_MODE_SOFT_PUSH;
  behaviour.state = scarab_BEHAVIOUR_MANUAL;
  behaviour.inputs[3] = -0.3;
  bus::assign(behaviour.reason, "operator: mode soft_push");
  behaviour.bs_rad = 0.1;
  behaviour.as_threshold_rad = 0.951;
  behaviour.trigger = scarab_TRIGGER_FRONT_ANGLE;
  Live live;
  see(live, behaviour);
  EXPECT_FALSE(live.by_load);
  EXPECT_EQ(live.mode, "soft_push");
  EXPECT_EQ(live.state, "manual");
  EXPECT_EQ(live.reason, "operator: mode soft_push");
  EXPECT_EQ(live.inputs[3], -0.3);
  EXPECT_EQ(live.bs_rad, 0.1);
  EXPECT_EQ(live.as_threshold_rad, 0.951);
}

TEST(Adapter, TakesTheLoadThatSwitchesInThePlaceOfAs) {
  scarab_Behaviour behaviour{};
  behaviour.trigger = scarab_TRIGGER_FOOT_FORCE;
  behaviour.trigger_value = 9.5;
  behaviour.trigger_threshold = 12.5;
  Live live;
  see(live, behaviour);
  EXPECT_TRUE(live.by_load);
  EXPECT_EQ(live.trigger, "foot force");
  EXPECT_EQ(live.trigger_unit, "N");
  EXPECT_EQ(live.trigger_value, 9.5);
  EXPECT_EQ(live.trigger_threshold, 12.5);
}

/// A trial in its safe stop, as the tick master and robot_state tell it.
class StandingTrial : public testing::Test {
 protected:
  StandingTrial() {
    state_.header.trial = report_.header.trial = 3;
    state_.phase = scarab_PHASE_SAFE_STOP;
    report_.lifecycle = scarab_LIFECYCLE_INACTIVE;
    report_.message = "safe stop: the device is lost: /dev/ttyUSB0: unplugged";
  }
  Live seen() {
    Live live;
    see(live, state_);
    see(live, {{{"robot_bridge", 0}, report_}}, "robot_bridge/0");
    return live;
  }

  scarab_RobotState state_{};
  runtime::ServiceReport report_;
};

TEST_F(StandingTrial, RunsThoughItsDeviceIsLost) {
  const Live live = seen();
  EXPECT_TRUE(live.trial_runs);
  EXPECT_TRUE(live.safe_stop);
  EXPECT_EQ(live.phase, "safe stop");
}

TEST_F(StandingTrial, RunsThoughItIsPaused) {
  report_.message = "paused by the operator";
  EXPECT_TRUE(seen().trial_runs);
}

TEST_F(StandingTrial, IsOverAfterItsLastTick) {
  state_.phase = scarab_PHASE_FAILED;
  const Live live = seen();
  EXPECT_FALSE(live.trial_runs);
  EXPECT_TRUE(live.safe_stop) << "it is latched";
}

TEST_F(StandingTrial, WasLeftWhereTheTickMasterSaysSomethingElse) {
  report_.message = "waits for the robot at /dev/ttyUSB0";
  EXPECT_FALSE(seen().trial_runs) << "the next one waits";
  report_.message = "safe stop: operator emergency stop";
  report_.header.trial = 0;
  EXPECT_FALSE(seen().trial_runs) << "it has been started anew";
  report_.header.trial = 3;
  report_.lifecycle = scarab_LIFECYCLE_FINALISED;
  EXPECT_FALSE(seen().trial_runs);
}

TEST(Adapter, ATickMasterThatIsActiveRunsATrial) {
  runtime::ServiceReport report;
  report.lifecycle = scarab_LIFECYCLE_ACTIVE;
  Live live;
  see(live, {{{"plant", 0}, report}}, "plant/0");
  EXPECT_TRUE(live.trial_runs) << "on its way home, before the first robot_state";
  see(live, {}, "plant/0");
  EXPECT_FALSE(live.trial_runs);
}

}  // namespace
}  // namespace scarab::drive
