#include "services/robot_bridge/core/lifecycle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/unit/robot_bridge/core/noting_driver.hpp"

namespace scarab::bridge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto kUnconfigured = LifecycleState::kUnconfigured;
constexpr auto kInactive = LifecycleState::kInactive;
constexpr auto kActive = LifecycleState::kActive;
constexpr auto kFinalised = LifecycleState::kFinalised;

class LifecycleTest : public testing::Test {
 protected:
  void bring_to(LifecycleState state) {
    if (state == kInactive || state == kActive) lifecycle_.configure();
    if (state == kActive) lifecycle_.activate({});
    if (state == kFinalised) lifecycle_.finalise();
    driver_.calls.clear();
  }

  NotingDriver driver_;
  Lifecycle lifecycle_{driver_, SafeStop::kRelease};
};

TEST_F(LifecycleTest, BeginsUnconfiguredAndTouchesNothing) {
  EXPECT_EQ(lifecycle_.state(), kUnconfigured);
  EXPECT_THAT(driver_.calls, IsEmpty());
}

TEST_F(LifecycleTest, GoesThroughItsStates) {
  lifecycle_.configure();
  EXPECT_EQ(lifecycle_.state(), kInactive);
  (void)lifecycle_.read();
  lifecycle_.activate({0.5});
  EXPECT_EQ(lifecycle_.state(), kActive);
  EXPECT_EQ(driver_.held_rad[0], 0.5);
  (void)lifecycle_.read();
  lifecycle_.write({0.6});
  EXPECT_EQ(driver_.written_rad[0], 0.6);
  EXPECT_TRUE(lifecycle_.deactivate());
  EXPECT_EQ(lifecycle_.state(), kInactive);
  lifecycle_.finalise();
  EXPECT_EQ(lifecycle_.state(), kFinalised);
  EXPECT_THAT(driver_.calls,
              ElementsAre("open", "read", "activate", "read", "write", "release", "close"));
}

TEST_F(LifecycleTest, HoldingStaysActive) {
  bring_to(kActive);
  EXPECT_TRUE(lifecycle_.hold());
  EXPECT_EQ(lifecycle_.state(), kActive);
  EXPECT_THAT(driver_.calls, ElementsAre("hold"));
}

TEST_F(LifecycleTest, IsActivatedAgainAfterAStopOfEitherKind) {
  bring_to(kActive);
  lifecycle_.deactivate();
  lifecycle_.activate({});
  lifecycle_.hold();
  lifecycle_.activate({});
  EXPECT_EQ(lifecycle_.state(), kActive);
  EXPECT_THAT(driver_.calls, ElementsAre("release", "activate", "hold", "activate"));
}

TEST_F(LifecycleTest, AFailedOpeningLeavesItUnconfigured) {
  driver_.fails = "open";
  EXPECT_THROW(lifecycle_.configure(), DeviceError);
  EXPECT_EQ(lifecycle_.state(), kUnconfigured);
  driver_.fails.clear();
  lifecycle_.configure();
  EXPECT_EQ(lifecycle_.state(), kInactive);
}

TEST_F(LifecycleTest, AFailedActivationIsRolledBack) {
  bring_to(kInactive);
  driver_.fails = "activate";
  EXPECT_THROW(lifecycle_.activate({}), DeviceError);
  EXPECT_THAT(driver_.calls, ElementsAre("activate", "release"));
  EXPECT_EQ(lifecycle_.state(), kInactive);
}

TEST_F(LifecycleTest, ARollbackThatIsNotConfirmedGivesTheDeviceUp) {
  bring_to(kInactive);
  driver_.fails = "activate";
  driver_.stops = false;
  EXPECT_THROW(lifecycle_.activate({}), DeviceError);
  EXPECT_THAT(driver_.calls, ElementsAre("activate", "release", "close"));
  EXPECT_EQ(lifecycle_.state(), kUnconfigured);
}

TEST_F(LifecycleTest, AnErrorDeactivates) {
  for (const char* call : {"read", "write"}) {
    NotingDriver driver;
    Lifecycle lifecycle(driver, SafeStop::kRelease);
    lifecycle.configure();
    lifecycle.activate({});
    driver.calls.clear();
    driver.fails = call;
    if (driver.fails == "read") {
      EXPECT_THROW((void)lifecycle.read(), DeviceError);
    } else {
      EXPECT_THROW(lifecycle.write({}), DeviceError);
    }
    EXPECT_THAT(driver.calls, ElementsAre(call, "release", "close"));
    EXPECT_EQ(lifecycle.state(), kUnconfigured);
    EXPECT_EQ(lifecycle.failures(), 1U);
  }
}

TEST(LifecycleThatHolds, HoldsWhenTheDeviceFails) {
  NotingDriver driver;
  Lifecycle lifecycle(driver, SafeStop::kHold);
  lifecycle.configure();
  lifecycle.activate({});
  driver.calls.clear();
  driver.fails = "read";
  EXPECT_THROW((void)lifecycle.read(), DeviceError);
  EXPECT_THAT(driver.calls, ElementsAre("read", "hold", "close"));
  EXPECT_EQ(lifecycle.state(), kUnconfigured);
}

TEST_F(LifecycleTest, AnErrorWithMotorsOffOnlyClosesTheDevice) {
  bring_to(kInactive);
  driver_.fails = "read";
  EXPECT_THROW((void)lifecycle_.read(), DeviceError);
  EXPECT_THAT(driver_.calls, ElementsAre("read", "close"));
  EXPECT_EQ(lifecycle_.state(), kUnconfigured);
}

TEST_F(LifecycleTest, StopsThatAreNotConfirmedAreCountedAndStopAllTheSame) {
  bring_to(kActive);
  driver_.stops = false;
  EXPECT_FALSE(lifecycle_.hold());
  EXPECT_FALSE(lifecycle_.deactivate());
  EXPECT_EQ(lifecycle_.state(), kInactive);
  EXPECT_EQ(lifecycle_.unconfirmed_stops(), 2U);
}

TEST_F(LifecycleTest, ADeviceWithoutASwitchIsNotAskedToConfirm) {
  driver_.has_switch = driver_.stops = false;
  bring_to(kActive);
  EXPECT_TRUE(lifecycle_.deactivate());
  EXPECT_THAT(driver_.calls, ElementsAre("release"));
  EXPECT_EQ(lifecycle_.unconfirmed_stops(), 0U);
}

TEST_F(LifecycleTest, GivingUpIsClosingAndNothingElse) {
  bring_to(kActive);
  lifecycle_.give_up();
  EXPECT_THAT(driver_.calls, ElementsAre("close"));
  EXPECT_EQ(lifecycle_.state(), kUnconfigured);
}

TEST_F(LifecycleTest, FinalisingSwitchesOffWhateverTheState) {
  bring_to(kActive);
  lifecycle_.finalise();
  EXPECT_THAT(driver_.calls, ElementsAre("release", "close"));
  lifecycle_.finalise();
  EXPECT_EQ(driver_.calls.size(), 2U) << "once";
}

TEST(LifecycleEnd, SwitchesOff) {
  NotingDriver driver;
  {
    Lifecycle lifecycle(driver, SafeStop::kHold);
    lifecycle.configure();
    lifecycle.activate({});
    driver.calls.clear();
  }
  EXPECT_THAT(driver.calls, ElementsAre("release", "close"));
}

/// Which calls each state allows; all others throw and touch no device.
struct Allowed {
  LifecycleState state;
  bool configure, activate, read, write;
};

class EachState : public testing::TestWithParam<Allowed> {};

template <class Call>
void expect_allowed(LifecycleState state, bool allowed, const char* name, const Call& call) {
  NotingDriver driver;
  Lifecycle lifecycle(driver, SafeStop::kRelease);
  if (state == kInactive || state == kActive) lifecycle.configure();
  if (state == kActive) lifecycle.activate({});
  if (state == kFinalised) lifecycle.finalise();
  driver.calls.clear();
  if (allowed) {
    EXPECT_NO_THROW(call(lifecycle)) << name;
    EXPECT_EQ(driver.calls.size(), 1U) << name;
    return;
  }
  EXPECT_THROW(call(lifecycle), std::logic_error) << name;
  EXPECT_THAT(driver.calls, IsEmpty()) << name;
  EXPECT_EQ(lifecycle.state(), state) << name;
}

TEST_P(EachState, AllowsTheseCallsAndNoOther) {
  const Allowed& allowed = GetParam();
  expect_allowed(allowed.state, allowed.configure, "configure", [](auto& l) { l.configure(); });
  expect_allowed(allowed.state, allowed.activate, "activate", [](auto& l) { l.activate({}); });
  expect_allowed(allowed.state, allowed.read, "read", [](auto& l) { (void)l.read(); });
  expect_allowed(allowed.state, allowed.write, "write", [](auto& l) { l.write({}); });
}

TEST_P(EachState, StoppingTouchesOnlyMotorsThatAreOn) {
  NotingDriver driver;
  Lifecycle lifecycle(driver, SafeStop::kRelease);
  const LifecycleState state = GetParam().state;
  if (state == kInactive || state == kActive) lifecycle.configure();
  if (state == kActive) lifecycle.activate({});
  if (state == kFinalised) lifecycle.finalise();
  driver.calls.clear();
  EXPECT_TRUE(lifecycle.hold());
  EXPECT_TRUE(lifecycle.deactivate());
  EXPECT_EQ(driver.calls.size(), state == kActive ? 2U : 0U);
}

INSTANTIATE_TEST_SUITE_P(Lifecycle, EachState,
                         testing::Values(Allowed{kUnconfigured, true, false, false, false},
                                         Allowed{kInactive, false, true, true, false},
                                         Allowed{kActive, false, true, true, true},
                                         Allowed{kFinalised, false, false, false, false}),
                         [](const auto& one) { return std::string(name_of(one.param.state)); });

static_assert(noexcept(std::declval<Lifecycle&>().hold()));
static_assert(noexcept(std::declval<Lifecycle&>().deactivate()));
static_assert(noexcept(std::declval<Lifecycle&>().finalise()));

}  // namespace
}  // namespace scarab::bridge
