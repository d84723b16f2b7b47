#include "common/config/unit.hpp"

#include <gtest/gtest.h>

namespace scarab::config {
namespace {

TEST(UnitOf, IsTheLongestThatTheNameEndsIn) {
  EXPECT_EQ(unit_of("length_m"), "m");
  EXPECT_EQ(unit_of("hinge_x_m"), "m");
  EXPECT_EQ(unit_of("slip_speed_m_s"), "m/s");
  EXPECT_EQ(unit_of("gravity_m_s2"), "m/s^2");
  EXPECT_EQ(unit_of("kp_nm_rad"), "N m/rad");
  EXPECT_EQ(unit_of("kd_nm_s_rad"), "N m s/rad");
  EXPECT_EQ(unit_of("damping_n_s_m"), "N s/m");
  EXPECT_EQ(unit_of("arm_ticks"), "ticks");
}

TEST(UnitOf, IsEmptyWhereTheNameHasNone) {
  EXPECT_EQ(unit_of("w11"), "");
  EXPECT_EQ(unit_of("smoothing"), "");
  EXPECT_EQ(unit_of("m"), "") << "a name, not a unit";
  EXPECT_EQ(unit_of(""), "");
}

TEST(UnitOf, IsEmptyWhereOnlyTheEndOfTheUnitIsKnown) {
  EXPECT_EQ(unit_of("walk_rad_s_s"), "") << "not s";
  EXPECT_EQ(unit_of("density_n_rad"), "") << "not rad";
}

}  // namespace
}  // namespace scarab::config
