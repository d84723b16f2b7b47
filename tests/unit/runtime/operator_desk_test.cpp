#include "common/runtime/operator_desk.hpp"

#include <gtest/gtest.h>

#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::runtime {
namespace {

class OperatorDeskTest : public testing::Test {
 protected:
  OperatorDeskTest() {
    wait_set_.attach(desk_.reader());
    EXPECT_TRUE(test::eventually(
        [&] { return !writer_.matched().empty() && !desk_.reader().matched().empty(); }));
  }

  OperatorDesk::Requests say(scarab_OperatorCommand command, const std::string& reason = "") {
    scarab_Operator said{};
    said.command = command;
    said.header.stamp_ns = stamp_ns_ = bus::now_ns();
    bus::assign(said.reason, reason);
    return say(said);
  }
  OperatorDesk::Requests say(const scarab_Operator& said) {
    last_ = said;
    writer_.write(said);
    EXPECT_TRUE(wait_set_.wait(test::kPatience));
    return desk_.update();
  }

  bus::Participant person_{test::test_options("operator")};
  bus::Participant plant_{test::test_options("plant")};
  bus::Writer<scarab_Operator> writer_{person_, bus::kOperator};
  bus::WaitSet wait_set_{plant_};
  OperatorDesk desk_{plant_};
  std::int64_t stamp_ns_ = 0;
  scarab_Operator last_{};
};

TEST_F(OperatorDeskTest, RunsUntilToldOtherwise) {
  EXPECT_FALSE(desk_.paused());
  const auto requests = desk_.update();
  EXPECT_FALSE(requests.stop || requests.emergency_stop || requests.reset);
}

TEST_F(OperatorDeskTest, PauseHoldsUntilStart) {
  say(scarab_OPERATOR_PAUSE);
  EXPECT_TRUE(desk_.paused());
  desk_.update();
  EXPECT_TRUE(desk_.paused());
  say(scarab_OPERATOR_START);
  EXPECT_FALSE(desk_.paused());
}

TEST_F(OperatorDeskTest, EachStepLetsOneTickThrough) {
  say(scarab_OPERATOR_PAUSE);
  say(scarab_OPERATOR_STEP);
  say(scarab_OPERATOR_STEP);
  EXPECT_FALSE(desk_.paused());
  desk_.tick_started();
  EXPECT_FALSE(desk_.paused());
  desk_.tick_started();
  EXPECT_TRUE(desk_.paused());
}

TEST_F(OperatorDeskTest, StepInAMovingTrialPausesAfterOneTick) {
  say(scarab_OPERATOR_STEP);
  EXPECT_FALSE(desk_.paused());
  desk_.tick_started();
  EXPECT_TRUE(desk_.paused());
}

TEST_F(OperatorDeskTest, StartForgetsStepsThatAreLeft) {
  say(scarab_OPERATOR_STEP);
  say(scarab_OPERATOR_STEP);
  say(scarab_OPERATOR_START);
  desk_.tick_started();
  desk_.tick_started();
  EXPECT_FALSE(desk_.paused());
}

TEST_F(OperatorDeskTest, ANewTrialIsNotPaused) {
  say(scarab_OPERATOR_PAUSE);
  desk_.begin_trial();
  EXPECT_FALSE(desk_.paused());
}

TEST_F(OperatorDeskTest, StopsAreToldOnceWithTheirReason) {
  EXPECT_EQ(say(scarab_OPERATOR_STOP, "lunch").stop, "operator stop: lunch");
  EXPECT_FALSE(desk_.update().stop);
  EXPECT_EQ(say(scarab_OPERATOR_EMERGENCY_STOP).emergency_stop,
            "operator emergency stop: no reason given");
  EXPECT_TRUE(say(scarab_OPERATOR_RESET).reset);
  EXPECT_FALSE(desk_.update().reset);
}

TEST_F(OperatorDeskTest, AcknowledgesWhatItCarriedOut) {
  EXPECT_EQ(desk_.stamp_ns(), 0);
  for (const auto command : {scarab_OPERATOR_PAUSE, scarab_OPERATOR_EMERGENCY_STOP}) {
    say(command);
    EXPECT_EQ(desk_.stamp_ns(), stamp_ns_);
  }
}

/// What a reader is given that joins late, or again after a network was cut.
TEST_F(OperatorDeskTest, ARepeatedResetDoesNotEndALaterStop) {
  say(scarab_OPERATOR_RESET);
  const scarab_Operator reset = last_;
  ASSERT_TRUE(say(scarab_OPERATOR_EMERGENCY_STOP).emergency_stop);
  EXPECT_FALSE(say(reset).reset);
}

/// Said in one breath: the stop is the last word.
TEST_F(OperatorDeskTest, AResetBeforeAStopDoesNotEndIt) {
  bool in_one_go = false;  // the desk has taken both at once; it may take more than one try
  for (int go = 0; go < 1000 && !in_one_go; ++go) {
    for (const auto command : {scarab_OPERATOR_RESET, scarab_OPERATOR_EMERGENCY_STOP}) {
      scarab_Operator said{};
      said.command = command;
      said.header.stamp_ns = bus::now_ns();
      writer_.write(said);
    }
    in_one_go = true;
    ASSERT_TRUE(test::eventually([&] {
      const auto requests = desk_.update();
      if (!requests.emergency_stop) in_one_go = in_one_go && !requests.reset;
      EXPECT_FALSE(requests.emergency_stop && requests.reset);
      return requests.emergency_stop.has_value();
    }));
  }
  EXPECT_TRUE(in_one_go);
}

TEST_F(OperatorDeskTest, OldWordsDoNotCountButAnEmergencyStopDoes) {
  scarab_Operator old{};
  old.header.stamp_ns = bus::now_ns() - 60'000'000'000;
  old.command = scarab_OPERATOR_PAUSE;
  say(old);
  EXPECT_FALSE(desk_.paused());
  old.command = scarab_OPERATOR_EMERGENCY_STOP;
  EXPECT_TRUE(say(old).emergency_stop);
  EXPECT_FALSE(say(old).emergency_stop) << "it has been carried out, and perhaps reset since";
}

TEST_F(OperatorDeskTest, LeavesTheSupervisorsCommandsToIt) {
  say(scarab_OPERATOR_PAUSE);
  const std::int64_t paused_at_ns = stamp_ns_;
  for (const auto command : {scarab_OPERATOR_AUTOMATIC, scarab_OPERATOR_STRATEGY,
                             scarab_OPERATOR_MODE, scarab_OPERATOR_INPUTS}) {
    const auto requests = say(command);
    EXPECT_FALSE(requests.stop || requests.emergency_stop || requests.reset);
    EXPECT_TRUE(desk_.paused());
    EXPECT_EQ(desk_.stamp_ns(), paused_at_ns);
  }
}

}  // namespace
}  // namespace scarab::runtime
