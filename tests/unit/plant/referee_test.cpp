#include "services/plant/core/referee.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scarab::plant {
namespace {

using ::testing::HasSubstr;

constexpr RefereeConfig kLimits{0.06, 0.80, 0.25, 1.2};
constexpr Wall kWall{-1.39, 0.0005, 0.10};

/// The robot close behind the object on the path.
Standing good(double time_s = 10) {
  Standing out;
  out.time_s = time_s;
  out.trunk_end = Eigen::Vector3d(-0.7, 0, 0.1);
  out.object = Eigen::Vector3d(-1.0, 0, 0.09);
  out.object_travel_m = 0.5;
  return out;
}

Referee referee(Goal goal) {
  TrialSpec trial;
  trial.goal = goal;
  trial.goal_distance_m = 1.46;
  trial.time_limit_s = 60;
  return {kLimits, trial, kWall};
}

TEST(Referee, IsSilentWhileTheTrialRuns) {
  for (const Goal goal : {Goal::kNone, Goal::kTravel, Goal::kAcross}) {
    const Ruling ruling = referee(goal).judge(good());
    EXPECT_EQ(ruling.verdict, Verdict::kOpen);
    EXPECT_EQ(ruling.time_s, 0);
    EXPECT_TRUE(ruling.reason.empty());
  }
}

TEST(Referee, TravelSucceedsAtTheDistance) {
  Standing now = good(14.5);
  now.object_travel_m = 1.459;
  EXPECT_EQ(referee(Goal::kTravel).judge(now).verdict, Verdict::kOpen);
  now.object_travel_m = 1.461;
  const Ruling ruling = referee(Goal::kTravel).judge(now);
  EXPECT_EQ(ruling.verdict, Verdict::kSuccess);
  EXPECT_EQ(ruling.time_s, 14.5);
  EXPECT_THAT(ruling.reason, HasSubstr("1.461 m of 1.460 m"));
}

TEST(Referee, AcrossSucceedsPastTheWall) {
  Standing now = good(21);
  now.trunk_end.x() = -1.2;
  now.object.x() = kWall.x - 0.059;
  EXPECT_EQ(referee(Goal::kAcross).judge(now).verdict, Verdict::kOpen);
  now.object.x() = kWall.x - 0.061;
  const Ruling ruling = referee(Goal::kAcross).judge(now);
  EXPECT_EQ(ruling.verdict, Verdict::kSuccess);
  EXPECT_THAT(ruling.reason, HasSubstr("0.061 m past the 0.100 m obstacle"));
}

TEST(Referee, WalkSucceedsAtTheDistanceWhereverTheObjectIs) {
  Standing now = good(25);
  now.object.x() = -50;
  now.trunk_travel_m = 1.459;
  EXPECT_EQ(referee(Goal::kWalk).judge(now).verdict, Verdict::kOpen);
  now.trunk_travel_m = 1.461;
  const Ruling ruling = referee(Goal::kWalk).judge(now);
  EXPECT_EQ(ruling.verdict, Verdict::kSuccess);
  EXPECT_THAT(ruling.reason, HasSubstr("the robot walked 1.461 m of 1.460 m"));
  now = good(60);
  now.trunk_travel_m = 0.4;
  EXPECT_EQ(referee(Goal::kWalk).judge(now).verdict, Verdict::kFailure);
  EXPECT_THAT(referee(Goal::kWalk).judge(now).reason, HasSubstr("the robot walked 0.400 m"));
}

TEST(Referee, FailsWhenTheObjectIsLost) {
  Standing ahead = good();
  ahead.object.x() = ahead.trunk_end.x() - 0.81;
  EXPECT_THAT(referee(Goal::kTravel).judge(ahead).reason, HasSubstr("0.81 m from the trunk's end"));
  EXPECT_EQ(referee(Goal::kTravel).judge(ahead).verdict, Verdict::kFailure);
  Standing aside = good();
  aside.trunk_end.y() = 0.26;
  EXPECT_THAT(referee(Goal::kAcross).judge(aside).reason, HasSubstr("0.26 m sideways"));
  EXPECT_EQ(referee(Goal::kAcross).judge(aside).verdict, Verdict::kFailure);
  EXPECT_EQ(referee(Goal::kNone).judge(aside).verdict, Verdict::kOpen)
      << "no goal, no object to lose";
}

TEST(Referee, FailsWhenTheRobotOverturns) {
  Standing now = good();
  now.trunk_tilt_rad = 1.3;
  for (const Goal goal : {Goal::kNone, Goal::kTravel, Goal::kAcross}) {
    EXPECT_EQ(referee(goal).judge(now).verdict, Verdict::kFailure);
    EXPECT_THAT(referee(goal).judge(now).reason, HasSubstr("overturned: tilt 1.30 rad"));
  }
}

TEST(Referee, TimeLimitIsTheSuccessOnlyWithoutAGoal) {
  const Standing now = good(60);
  EXPECT_EQ(referee(Goal::kNone).judge(now).verdict, Verdict::kSuccess);
  EXPECT_EQ(referee(Goal::kTravel).judge(now).verdict, Verdict::kFailure);
  EXPECT_THAT(referee(Goal::kAcross).judge(now).reason, HasSubstr("time limit of 60.0 s"));
}

TEST(Referee, GoalReachedOnTheLastTickCounts) {
  Standing now = good(60);
  now.object_travel_m = 1.5;
  EXPECT_EQ(referee(Goal::kTravel).judge(now).verdict, Verdict::kSuccess);
}

TEST(Standing, IsMeasuredAtTheTrunksEnd) {
  MotionState state;
  state.trunk_position = Eigen::Vector3d(1, 2, 0.1);
  state.trunk_orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitZ()));
  state.object_position = Eigen::Vector3d(-0.7, 0, 0.09);
  const Standing now =
      standing(state, 3, 0.215, {-0.5, state.trunk_position + Eigen::Vector3d(0.3, -0.4, 1)});
  EXPECT_NEAR(now.trunk_travel_m, 0.5, 1e-12) << "on the ground alone";
  EXPECT_NEAR((now.trunk_end - Eigen::Vector3d(1, 2 - 0.215, 0.1)).norm(), 0, 1e-12);
  EXPECT_NEAR(now.trunk_tilt_rad, 0, 1e-7);
  EXPECT_NEAR(now.object_travel_m, 0.2, 1e-12);
}

}  // namespace
}  // namespace scarab::plant
