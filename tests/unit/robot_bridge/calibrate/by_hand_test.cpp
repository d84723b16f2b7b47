#include "services/robot_bridge/calibrate/by_hand.hpp"

#include <gmock/gmock.h>

#include "tests/unit/robot_bridge/calibrate/bench_double.hpp"

namespace scarab::bridge::calibrate {
namespace {

using testing::HasSubstr;
using Outcome = Finding::Outcome;

constexpr std::size_t kCr1 = 10;

class CalibrateByHand : public testing::Test {
 protected:
  Finding find() {
    robot::JointVector reference{};
    reference[kCr1] = -0.25;
    return ByHand(servos_, person_, reference).find(kCr1);
  }

  ServosInHand servos_;
  Person person_{servos_};
};

TEST_F(CalibrateByHand, FindsOffsetDirectionAndRange) {
  // The servo runs against the joint; the joint's 0 is at 0.3 of the servo.
  person_.moves(kCr1, 0.55).presses(Key::kEnter);
  person_.moves(kCr1, 0.2).presses(Key::kEnter);
  person_.moves(kCr1, -0.4).moves(kCr1, 1.7).moves(kCr1, 0.9).presses(Key::kEnter);
  const Finding finding = find();
  ASSERT_EQ(finding.outcome, Outcome::kFound);
  EXPECT_NEAR(finding.calibration.offset_rad, 0.3, 1e-12);
  EXPECT_EQ(finding.calibration.direction, -1);
  EXPECT_NEAR(finding.calibration.min_rad, -0.4, 1e-12);
  EXPECT_NEAR(finding.calibration.max_rad, 1.7, 1e-12);
  EXPECT_NEAR(to_joint_rad(finding.calibration, 0.55), -0.25, 1e-12);
  EXPECT_TRUE(servos_.written_rad.empty() && !servos_.activated_rad) << "motors stay off";
}

TEST_F(CalibrateByHand, AsksAgainWhenTheJointWasNotMoved) {
  person_.presses(Key::kEnter);                    // stands at 0
  person_.moves(kCr1, 0.05).presses(Key::kEnter);  // hardly moved
  person_.moves(kCr1, 0.4).presses(Key::kEnter);   // positive direction
  person_.moves(kCr1, 0.5).presses(Key::kEnter);   // hardly a travel
  person_.moves(kCr1, -1).moves(kCr1, 1).presses(Key::kEnter);
  const Finding finding = find();
  ASSERT_EQ(finding.outcome, Outcome::kFound);
  EXPECT_EQ(finding.calibration.direction, 1);
  EXPECT_EQ(finding.calibration.min_rad, -1);
  EXPECT_THAT(person_.heard, HasSubstr("less than 6 degrees"));
  EXPECT_THAT(person_.heard, HasSubstr("less than 17 degrees"));
}

TEST_F(CalibrateByHand, CanBeSkippedOrLeftAtEachStep) {
  for (int steps = 0; steps < 3; ++steps) {
    for (const Key last : {Key::kSkip, Key::kQuit}) {
      Person person(servos_);
      if (steps > 0) person.moves(kCr1, 0).presses(Key::kEnter);
      if (steps > 1) person.moves(kCr1, 0.5).presses(Key::kEnter);
      person.presses(last);
      const Finding finding = ByHand(servos_, person, {}).find(kCr1);
      EXPECT_EQ(finding.outcome, last == Key::kSkip ? Outcome::kSkipped : Outcome::kQuit);
    }
  }
}

TEST_F(CalibrateByHand, EndsWithTheInput) { EXPECT_EQ(find().outcome, Outcome::kQuit); }

TEST_F(CalibrateByHand, NamesAServoThatTellsNothing) {
  servos_.mute = kCr1;
  try {
    (void)find();
    FAIL() << "found something";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("CR1"));
  }
}

TEST_F(CalibrateByHand, SaysWhatThePoseLooksLike) {
  (void)find();
  EXPECT_THAT(person_.heard, HasSubstr("CR1: put it so: -0.250 rad (-14.3 deg)"));
}

}  // namespace
}  // namespace scarab::bridge::calibrate
