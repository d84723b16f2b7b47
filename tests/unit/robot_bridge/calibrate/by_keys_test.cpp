#include "services/robot_bridge/calibrate/by_keys.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "services/robot_bridge/calibrate/own_scales.hpp"
#include "tests/unit/robot_bridge/calibrate/bench_double.hpp"

namespace scarab::bridge::calibrate {
namespace {

using testing::HasSubstr;
using Outcome = Finding::Outcome;

constexpr std::size_t kTl0 = 0;
constexpr std::chrono::milliseconds kNoWait{0};

robot::RobotModel model() {
  robot::RobotModel robot;
  for (robot::Joint& joint : robot.joints) {
    joint.min_rad = -0.8;
    joint.max_rad = 0.8;
  }
  return robot;
}

class CalibrateByKeys : public testing::Test {
 protected:
  ByKeys tool() {
    return {servos_, person_, robot_, own_scales(robot_, known_), known_, reference_rad_, kNoWait};
  }

  robot::RobotModel robot_ = model();
  Calibration known_;
  robot::JointVector reference_rad_{};
  ServosInHand servos_;
  Person person_{servos_};
};

TEST_F(CalibrateByKeys, PowersOnlyWhenAskedTo) {
  person_.presses(Key::kPlus).presses(Key::kQuit);
  EXPECT_FALSE(tool().power());
  EXPECT_FALSE(servos_.activated_rad.has_value());
  EXPECT_THAT(person_.heard, HasSubstr("every joint jumps"));
}

TEST_F(CalibrateByKeys, PowersWhereTheFileSaysThatThePoseIs) {
  known_.joints[kTl0] = JointCalibration{0.1, -1, -0.9, 0.9};
  reference_rad_[kTl0] = 0.3;
  person_.presses(Key::kEnter);
  EXPECT_TRUE(tool().power());
  ASSERT_TRUE(servos_.activated_rad.has_value());
  EXPECT_NEAR((*servos_.activated_rad)[kTl0], -0.2, 1e-12);
  EXPECT_EQ((*servos_.activated_rad)[5], 0) << "the middle of a servo nobody knows";
}

TEST_F(CalibrateByKeys, FindsDirectionAndLengthOfTheTravelFromTwoLooks) {
  // The real travel is half as long again as the nominal -0.8 to 0.8, and runs against the joint,
  // whose 0 is at -0.1 of the nominal scale: 5 steps down. 0.5 rad of it are a third of a rad of
  // the nominal scale; the nearest the keys come to it are 17 steps.
  person_.presses(Key::kMinus, 5).presses(Key::kEnter);
  person_.presses(Key::kMinus, 17).presses(Key::kEnter);
  const Finding finding = tool().find(kTl0);
  ASSERT_EQ(finding.outcome, Outcome::kFound);
  EXPECT_EQ(finding.calibration.direction, -1);
  const double stretch = 0.5 / (17 * ByKeys::kStep_rad);
  EXPECT_NEAR(finding.calibration.max_rad, 0.8 * stretch, 1e-12);
  EXPECT_NEAR(finding.calibration.min_rad, -0.8 * stretch, 1e-12);
  EXPECT_NEAR(finding.calibration.offset_rad, -0.1 * stretch, 1e-12);
}

TEST_F(CalibrateByKeys, KeepsDirectionAndTravelWhenAskedTo) {
  known_.joints[kTl0] = JointCalibration{0, -1, -0.9, 0.9};
  person_.presses(Key::kPlus, 3).presses(Key::kEnter).presses(Key::kKeep);
  const Finding finding = tool().find(kTl0);
  ASSERT_EQ(finding.outcome, Outcome::kFound);
  EXPECT_NEAR(finding.calibration.offset_rad, 0.06, 1e-12);
  EXPECT_EQ(finding.calibration.direction, -1);
  EXPECT_EQ(finding.calibration.max_rad, 0.9);
}

TEST_F(CalibrateByKeys, CannotKeepWhatTheFileDoesNotHave) {
  person_.presses(Key::kEnter).presses(Key::kKeep).presses(Key::kEnter);
  EXPECT_EQ(tool().find(kTl0).outcome, Outcome::kQuit);
  EXPECT_THAT(person_.heard, HasSubstr("not far enough"));
}

TEST_F(CalibrateByKeys, KeysHeldDownDoNotMakeItFaster) {
  person_.presses(Key::kPlus, 10).presses(Key::kSkip);
  ByKeys slow(servos_, person_, robot_, own_scales(robot_, known_), known_, reference_rad_,
              std::chrono::hours(1));
  EXPECT_EQ(slow.find(kTl0).outcome, Outcome::kSkipped);
  EXPECT_TRUE(servos_.written_rad.empty()) << "the time for a step had not come";
}

TEST_F(CalibrateByKeys, DrivesGentlyAndInsideTheTravel) {
  person_.presses(Key::kPlus, 100).presses(Key::kSkip);
  EXPECT_EQ(tool().find(kTl0).outcome, Outcome::kSkipped);
  ASSERT_GE(servos_.written_rad.size(), 100U);
  double before_rad = 0;
  for (const robot::JointVector& goals : servos_.written_rad) {
    EXPECT_LE(std::abs(goals[kTl0] - before_rad), ByKeys::kSpeed_rad_s * 0.05 + 1e-12);
    EXPECT_LE(goals[kTl0], 0.8);
    EXPECT_EQ(goals[kTl0 + 1], 0);
    before_rad = goals[kTl0];
  }
  EXPECT_NEAR(before_rad, 0.8, 1e-9);
}

}  // namespace
}  // namespace scarab::bridge::calibrate
