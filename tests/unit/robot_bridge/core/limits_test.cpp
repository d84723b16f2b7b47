#include "services/robot_bridge/core/limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace scarab::bridge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::size_t kJoint = 7;  // CL1

LimitsConfig watching_all() {
  LimitsConfig config;
  config.confirm_readings = 3;
  config.clear_fraction = 0.9;
  config.temperature_max_c = 70;
  config.joint_current_max_a = 2;
  config.supply_current_max_a = 20;
  config.inclination_max_rad = 1;
  return config;
}

Readings healthy() {
  Readings readings;
  readings.temperature_c.fill(40);
  readings.current_a.fill(0.5);
  readings.supply_current_a = 6;
  readings.supply_current_source = Source::kMeasured;
  readings.imu_source = Source::kMeasured;
  return readings;
}

/// One way in which a robot must not go on.
struct Cause {
  const char* name;
  void (*set)(Readings&, double value);
  double beyond;   // the limit
  double between;  // within the limit, but not yet cleared
  const char* says;
};

void PrintTo(const Cause& cause, std::ostream* out) { *out << cause.name; }

const Cause kCauses[] = {
    {"temperature", [](Readings& r, double v) { r.temperature_c[kJoint] = v; }, 71, 65,
     "CL1 has 71.00 C, more than 70 C"},
    {"joint current", [](Readings& r, double v) { r.current_a[kJoint] = v; }, 2.5, 1.9,
     "CL1 draws 2.50 A, more than 2 A"},
    {"supply current", [](Readings& r, double v) { r.supply_current_a = v; }, 21, 19,
     "the robot draws 21.00 A, more than 20 A"},
    {"pitch", [](Readings& r, double v) { r.pitch_rad = v; }, 1.2, 0.95,
     "the trunk leans 1.20 rad, more than 1 rad"},
    {"roll, the other way", [](Readings& r, double v) { r.roll_rad = -v; }, 1.2, 0.95,
     "the trunk leans 1.20 rad"},
};

class EachLimit : public testing::TestWithParam<Cause> {
 protected:
  void observe(double value, int times = 1) {
    Readings readings = healthy();
    GetParam().set(readings, value);
    for (int i = 0; i < times; ++i) limits_.observe(readings);
  }
  void observe_healthy(int times) {
    for (int i = 0; i < times; ++i) limits_.observe(healthy());
  }

  Limits limits_{watching_all()};
};

TEST_P(EachLimit, RaisesAfterSomeReadingsInARow) {
  observe(GetParam().beyond, 2);
  EXPECT_FALSE(limits_.alarm().has_value());
  observe(GetParam().beyond);
  ASSERT_TRUE(limits_.alarm().has_value());
  EXPECT_THAT(*limits_.alarm(), HasSubstr(GetParam().says));
}

TEST_P(EachLimit, OneBadReadingNowAndThenStopsNoRobot) {
  for (int i = 0; i < 20; ++i) {
    observe(GetParam().beyond, 2);
    observe_healthy(1);
    EXPECT_FALSE(limits_.alarm().has_value());
  }
}

TEST_P(EachLimit, ClearsOnlyWellWithinAndConfirmed) {
  observe(GetParam().beyond, 3);
  observe(GetParam().between, 50);
  EXPECT_TRUE(limits_.alarm().has_value()) << "just below the limit is not well within it";
  observe_healthy(2);
  EXPECT_TRUE(limits_.alarm().has_value());
  observe_healthy(1);
  EXPECT_FALSE(limits_.alarm().has_value());
}

TEST_P(EachLimit, IsForgottenWithTheDevice) {
  observe(GetParam().beyond, 3);
  limits_.forget();
  EXPECT_FALSE(limits_.alarm().has_value());
  observe(GetParam().beyond, 2);
  EXPECT_FALSE(limits_.alarm().has_value());
}

INSTANTIATE_TEST_SUITE_P(Limits, EachLimit, testing::ValuesIn(kCauses));

TEST(Limits, AnErrorOfTheDeviceIsNamed) {
  Limits limits(watching_all());
  Readings readings = healthy();
  readings.device_error = "FR2 reports overload";
  for (int i = 0; i < 3; ++i) limits.observe(readings);
  EXPECT_EQ(limits.alarm(), "FR2 reports overload");
  for (int i = 0; i < 3; ++i) limits.observe(healthy());
  EXPECT_EQ(limits.alarm(), std::nullopt);
}

TEST(Limits, WhatIsNotToldNeitherRaisesNorClears) {
  Limits limits(watching_all());
  Readings silent = healthy();
  silent.temperature_c = unknown_of_each_joint();
  silent.supply_current_source = Source::kAbsent;
  silent.imu_source = Source::kCommanded;
  silent.pitch_rad = 3;
  silent.supply_current_a = 100;
  for (int i = 0; i < 10; ++i) limits.observe(silent);
  EXPECT_FALSE(limits.alarm().has_value());

  Readings hot = healthy();
  hot.temperature_c[kJoint] = 90;
  for (int i = 0; i < 3; ++i) {
    limits.observe(hot);
    limits.observe(silent);  // temperatures may come with every other exchange only
  }
  ASSERT_TRUE(limits.alarm().has_value());
  for (int i = 0; i < 10; ++i) limits.observe(silent);
  EXPECT_TRUE(limits.alarm().has_value());
}

TEST(Limits, ValuesThatAreNoNumbersDoNotRaise) {
  Limits limits(watching_all());
  Readings readings = healthy();
  readings.pitch_rad = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 10; ++i) limits.observe(readings);
  EXPECT_FALSE(limits.alarm().has_value());
}

TEST(Limits, WatchOnlyWhatTheyAreToldTo) {
  LimitsConfig config;
  config.confirm_readings = 1;
  Limits limits(config);
  Readings readings = healthy();
  readings.temperature_c.fill(200);
  readings.current_a.fill(100);
  readings.supply_current_a = 1000;
  readings.roll_rad = 3;
  limits.observe(readings);
  EXPECT_FALSE(limits.alarm().has_value());
}

TEST(Limits, OneConfirmationIsAtOnce) {
  LimitsConfig config = watching_all();
  config.confirm_readings = 1;
  Limits limits(config);
  Readings readings = healthy();
  readings.current_a[kJoint] = 5;
  limits.observe(readings);
  EXPECT_TRUE(limits.alarm().has_value());
  limits.observe(healthy());
  EXPECT_FALSE(limits.alarm().has_value());
}

}  // namespace
}  // namespace scarab::bridge
