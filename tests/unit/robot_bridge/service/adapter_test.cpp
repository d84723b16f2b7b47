#include "services/robot_bridge/adapter.hpp"

#include <gtest/gtest.h>

namespace scarab::bridge {
namespace {

TEST(Adapter, PassesOnWhatTheDeviceTellsWithItsSource) {
  Readings readings;
  readings.position_rad.value[4] = 0.5;
  readings.position_rad.source[4] = Source::kCommanded;
  readings.velocity_rad_s.value[5] = -2;
  readings.velocity_rad_s.source[5] = Source::kMeasured;
  readings.torque_nm.value[18] = 3;
  readings.torque_nm.source[18] = Source::kMeasured;
  readings.foot_force_n[2] = 12;
  readings.foot_force_source[2] = Source::kMeasured;
  readings.imu_source = Source::kMeasured;
  readings.roll_rad = 0.1;
  readings.pitch_rad = -0.2;
  readings.motion_source = Source::kMeasured;
  readings.angular_velocity_rad_s = {1, 2, 3};
  readings.acceleration_m_s2 = {4, 5, 6};
  readings.supply_current_source = Source::kMeasured;
  readings.supply_current_a = 7;

  scarab_RobotState state{};
  fill(state, readings);
  EXPECT_EQ(state.position_rad[4], 0.5);
  EXPECT_EQ(state.position_source[4], scarab_SOURCE_COMMANDED);
  EXPECT_EQ(state.velocity_rad_s[5], -2);
  EXPECT_EQ(state.velocity_source[5], scarab_SOURCE_MEASURED);
  EXPECT_EQ(state.torque_nm[18], 3);
  EXPECT_EQ(state.foot_force_n[2], 12);
  EXPECT_EQ(state.foot_force_source[2], scarab_SOURCE_MEASURED);
  EXPECT_EQ(state.foot_force_source[1], scarab_SOURCE_ABSENT);
  EXPECT_EQ(state.inclination_rad[0], 0.1);
  EXPECT_EQ(state.inclination_rad[1], -0.2);
  EXPECT_EQ(state.angular_velocity_rad_s[2], 3);
  EXPECT_EQ(state.acceleration_m_s2[0], 4);
  EXPECT_EQ(state.imu_source, scarab_SOURCE_MEASURED);
  EXPECT_EQ(state.motion_source, scarab_SOURCE_MEASURED);
  EXPECT_EQ(state.supply_current_a, 7);
}

TEST(Adapter, AnInclinometerIsNoGyroscope) {
  Readings readings;
  readings.imu_source = Source::kMeasured;
  readings.roll_rad = 0.1;
  readings.acceleration_m_s2 = {4, 5, 6};
  scarab_RobotState state{};
  fill(state, readings);
  EXPECT_EQ(state.imu_source, scarab_SOURCE_MEASURED);
  EXPECT_EQ(state.inclination_rad[0], 0.1);
  EXPECT_EQ(state.motion_source, scarab_SOURCE_ABSENT);
  EXPECT_EQ(state.acceleration_m_s2[2], 0);
}

TEST(Adapter, ANumberNobodyStandsForIsZero) {
  Readings readings;
  readings.position_rad.value.fill(0.5);
  readings.foot_force_n.fill(9);
  readings.roll_rad = readings.pitch_rad = 1;
  readings.acceleration_m_s2 = {1, 2, 3};
  readings.supply_current_a = 8;
  scarab_RobotState state{};
  fill(state, readings);
  for (std::size_t slot = 0; slot < 19; ++slot) {
    EXPECT_EQ(state.position_rad[slot], 0);
    EXPECT_EQ(state.position_source[slot], scarab_SOURCE_ABSENT);
  }
  EXPECT_EQ(state.foot_force_n[0], 0);
  EXPECT_EQ(state.inclination_rad[0], 0);
  EXPECT_EQ(state.acceleration_m_s2[2], 0);
  EXPECT_EQ(state.supply_current_a, 0);
}

}  // namespace
}  // namespace scarab::bridge
