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

}  // namespace
}  // namespace scarab::drive
