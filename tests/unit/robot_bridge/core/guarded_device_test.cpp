#include "services/robot_bridge/core/guarded_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/robot_bridge/core/noting_driver.hpp"

namespace scarab::bridge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kJoint = 4;

LimitsConfig strict() {
  LimitsConfig limits;
  limits.confirm_readings = 1;
  limits.temperature_max_c = 70;
  return limits;
}

robot::JointVector home() {
  robot::JointVector home_rad{};
  home_rad.fill(0.25);
  return home_rad;
}

class GuardedDeviceTest : public testing::Test {
 protected:
  /// All joints measured at this angle.
  void stands_at(double angle_rad) {
    driver_.readings.position_rad.value.fill(angle_rad);
    driver_.readings.position_rad.source.fill(Source::kMeasured);
  }
  void be_active() {
    device_.look_for(0);
    device_.activate();
    driver_.calls.clear();
  }

  NotingDriver driver_;
  GuardedDevice device_{driver_, SafeStop::kHold, strict(), home()};
};

TEST_F(GuardedDeviceTest, IsAbsentUntilItIsFound) {
  EXPECT_FALSE(device_.present());
  device_.exchange();
  EXPECT_THAT(driver_.calls, IsEmpty());
  device_.look_for(0);
  EXPECT_TRUE(device_.present());
  EXPECT_THAT(driver_.calls, ElementsAre("open"));
  device_.look_for(1);
  EXPECT_THAT(driver_.calls, ElementsAre("open"));
}

TEST_F(GuardedDeviceTest, IsLookedForLessAndLessOften) {
  driver_.fails = "open";
  std::vector<double> attempts_s;
  for (double now_s = 0; now_s < 20; now_s += 0.02) {
    const std::size_t before = driver_.calls.size();
    device_.look_for(now_s);
    if (driver_.calls.size() != before) attempts_s.push_back(now_s);
  }
  ASSERT_GE(attempts_s.size(), 10U);
  ASSERT_LE(attempts_s.size(), 14U);
  EXPECT_EQ(attempts_s.front(), 0);
  for (std::size_t i = 1; i < attempts_s.size(); ++i) {
    const double pause_s = attempts_s[i] - attempts_s[i - 1];
    EXPECT_GE(pause_s, GuardedDevice::kFirstPause_s - 1e-9);
    EXPECT_LE(pause_s, GuardedDevice::kLongestPause_s + 0.03);
  }
  EXPECT_EQ(device_.absence(), "no answer to open");
}

TEST_F(GuardedDeviceTest, HoldsWhereItStandsWhenItIsActivated) {
  stands_at(-0.4);
  be_active();
  EXPECT_EQ(driver_.held_rad[kJoint], -0.4);
  EXPECT_EQ(device_.held_rad()[kJoint], -0.4);
}

TEST_F(GuardedDeviceTest, IsTakenToStandAtHomeWhereNothingIsMeasured) {
  be_active();
  EXPECT_EQ(driver_.held_rad[kJoint], 0.25);
}

TEST_F(GuardedDeviceTest, IsTakenToStandWhereItWasToldLastWhereNothingIsMeasured) {
  be_active();
  robot::JointVector target_rad = home();
  target_rad[kJoint] = 0.6;
  device_.apply(target_rad);
  device_.rest();
  device_.activate();
  EXPECT_EQ(driver_.held_rad[kJoint], 0.6);
}

TEST_F(GuardedDeviceTest, IsWrittenOnlyWhileActiveAndNotStopped) {
  device_.apply(home());
  device_.look_for(0);
  device_.apply(home());
  EXPECT_THAT(driver_.calls, ElementsAre("open")) << "nothing is written before it is active";
  be_active();
  device_.apply(home());
  EXPECT_THAT(driver_.calls, ElementsAre("write"));
  device_.safe_stop();
  device_.apply(home());
  EXPECT_THAT(driver_.calls, ElementsAre("write", "hold"));
  device_.activate();
  device_.apply(home());
  EXPECT_THAT(driver_.calls, ElementsAre("write", "hold", "read", "activate", "write"));
  device_.rest();
  device_.apply(home());
  EXPECT_EQ(driver_.calls.back(), "release");
}

TEST_F(GuardedDeviceTest, ASafeStopBeforeItIsActiveTouchesNothing) {
  device_.look_for(0);
  device_.safe_stop();
  EXPECT_THAT(driver_.calls, ElementsAre("open"));
  device_.activate();
  device_.apply(home());
  EXPECT_EQ(driver_.calls.back(), "write");
}

TEST(GuardedDeviceThatReleases, DropsItsTorque) {
  NotingDriver driver;
  GuardedDevice device(driver, SafeStop::kRelease, strict(), home());
  device.look_for(0);
  device.activate();
  driver.calls.clear();
  device.safe_stop();
  EXPECT_THAT(driver.calls, ElementsAre("release"));
  EXPECT_EQ(device.state(), LifecycleState::kInactive);
  EXPECT_FALSE(device.fault().has_value());
}

class EachLoss : public GuardedDeviceTest, public testing::WithParamInterface<const char*> {
 protected:
  void lose() {
    driver_.fails = GetParam();
    if (driver_.fails == "read") device_.exchange();
    if (driver_.fails == "write") device_.apply(home());
    if (driver_.fails == "hold") {
      driver_.stops = false;
      device_.safe_stop();
    }
  }
};

TEST_P(EachLoss, IsAFaultUntilTheDeviceIsFoundAgain) {
  stands_at(0.1);
  driver_.readings.temperature_c.fill(30);
  be_active();
  device_.exchange();
  EXPECT_FALSE(device_.fault().has_value());
  lose();
  ASSERT_TRUE(device_.fault().has_value());
  EXPECT_THAT(*device_.fault(), HasSubstr("the device is lost: "));
  EXPECT_EQ(device_.state(), LifecycleState::kUnconfigured);
  EXPECT_EQ(driver_.calls.back(), "close");
  EXPECT_EQ(device_.losses(), 1U);
  EXPECT_EQ(device_.readings().position_rad.source[kJoint], Source::kAbsent);
  EXPECT_EQ(device_.readings().position_rad.value[kJoint], 0) << "what it told is over";
  EXPECT_TRUE(std::isnan(device_.readings().temperature_c[kJoint]));

  const std::string reason = *device_.fault();
  driver_.fails = "open";
  device_.look_for(0);
  EXPECT_EQ(device_.fault(), reason) << "the words stay the same";
  driver_.fails.clear();
  driver_.stops = true;
  device_.look_for(100);
  device_.exchange();
  EXPECT_EQ(device_.fault(), std::nullopt);
  EXPECT_EQ(device_.state(), LifecycleState::kInactive) << "motors stay off until activate()";
  device_.apply(home());
  EXPECT_EQ(driver_.calls.back(), "read");
  device_.activate();
  EXPECT_EQ(device_.state(), LifecycleState::kActive);
}

/// A robot that tells no angles stands where it was told to go before it was lost.
TEST_P(EachLoss, LeavesHeldWhatWasToldLast) {
  be_active();
  robot::JointVector target_rad = home();
  target_rad[kJoint] = 0.6;
  device_.apply(target_rad);
  lose();
  driver_.fails.clear();
  driver_.stops = true;
  device_.look_for(100);
  device_.activate();
  EXPECT_EQ(driver_.held_rad[kJoint], 0.6);
}

INSTANTIATE_TEST_SUITE_P(GuardedDevice, EachLoss, testing::Values("read", "write", "hold"));

TEST_F(GuardedDeviceTest, ALossWhileNobodyUsesItIsNoFault) {
  device_.look_for(0);
  driver_.fails = "read";
  device_.exchange();
  EXPECT_FALSE(device_.present());
  EXPECT_EQ(device_.fault(), std::nullopt);
  EXPECT_EQ(device_.absence(), "no answer to read");
}

TEST_F(GuardedDeviceTest, WhateverItsDriverThrowsIsALoss) {
  driver_.fails_oddly = true;
  driver_.fails = "open";
  device_.look_for(0);
  EXPECT_EQ(device_.absence(), "something odd in open");
  driver_.fails.clear();
  device_.look_for(1);
  device_.activate();
  driver_.fails = "write";
  device_.apply(home());
  EXPECT_EQ(device_.fault(), "the device is lost: something odd in write");
  EXPECT_EQ(driver_.calls.back(), "close");
}

TEST_F(GuardedDeviceTest, AFailedActivationLeavesMotorsOff) {
  device_.look_for(0);
  driver_.calls.clear();
  driver_.fails = "activate";
  EXPECT_THROW(device_.activate(), DeviceError);
  EXPECT_THAT(driver_.calls, ElementsAre("read", "activate", "release"));
  EXPECT_EQ(device_.state(), LifecycleState::kInactive);
  EXPECT_EQ(device_.fault(), std::nullopt);
}

TEST_F(GuardedDeviceTest, IsNotActivatedWhileItIsAbsent) {
  EXPECT_THROW(device_.activate(), DeviceError);
  device_.look_for(0);
  driver_.fails = "read";
  EXPECT_THROW(device_.activate(), DeviceError) << "lost while it was asked where it stands";
  EXPECT_EQ(driver_.calls.back(), "close");
}

TEST_F(GuardedDeviceTest, IsNotActivatedBeyondALimit) {
  driver_.readings.temperature_c[kJoint] = 90;
  device_.look_for(0);
  try {
    device_.activate();
    FAIL() << "activated though hot";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("TR1 has 90.00 C"));
  }
  EXPECT_EQ(std::count(driver_.calls.begin(), driver_.calls.end(), "activate"), 0);
  driver_.readings.temperature_c[kJoint] = 30;
  device_.activate();
  EXPECT_EQ(device_.state(), LifecycleState::kActive);
}

TEST_F(GuardedDeviceTest, ALimitIsAFaultWithMotorsStillOn) {
  be_active();
  driver_.readings.temperature_c[kJoint] = 90;
  device_.exchange();
  EXPECT_THAT(*device_.fault(), HasSubstr("TR1 has 90.00 C, more than 70 C"));
  EXPECT_EQ(device_.state(), LifecycleState::kActive) << "whether to stop is the gate's to say";
}

TEST_F(GuardedDeviceTest, RestThatIsNotConfirmedGivesTheDeviceUp) {
  be_active();
  driver_.stops = false;
  device_.rest();
  EXPECT_THAT(driver_.calls, ElementsAre("release", "close"));
  EXPECT_EQ(device_.absence(), "it did not confirm that its motors are off");
  EXPECT_EQ(device_.unconfirmed_stops(), 1U);
}

static_assert(noexcept(std::declval<GuardedDevice&>().safe_stop()));
static_assert(noexcept(std::declval<GuardedDevice&>().rest()));

}  // namespace
}  // namespace scarab::bridge
