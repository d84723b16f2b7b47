#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/premotor/f2_config.hpp"
#include "tests/unit/premotor/rhythm.hpp"

// The whole motor pattern of each action (paper, Table 1 and section 3) on the joint targets of
// parameter set F2.
namespace scarab::premotor {
namespace {

using robot::Leg;
using robot::LegJoint;

constexpr double kPi = 3.14159265358979323846;
constexpr LegJoint kT = LegJoint::kThoracoCoxal;
constexpr LegJoint kC = LegJoint::kCoxaTrochanteral;
constexpr LegJoint kF = LegJoint::kFemurTibia;
constexpr std::array<double, 3> kHindPose = {-0.6, 0.2, 0.8};

Recording record_action(const char* name) {
  return record(PremotorController(f2_config(), beetle()), {false, action(name).inputs, {}, 0.05});
}

Recording record_stationary() {
  return record(PremotorController(f2_config(), beetle()),
                {false, action("backward").inputs, kHindPose, 0.05});
}

double omega_of(const Recording& recording) {
  std::vector<std::array<double, 2>> orbit;
  for (const NetworkState& state : recording.states) {
    orbit.push_back(state.cpg);
  }
  return std::abs(turn_per_tick_rad(orbit));
}

double sense(const Recording& recording, Leg leg) {
  return walking_sense(target(recording, leg, kT), target(recording, leg, kC));
}

class EveryAction : public testing::TestWithParam<const char*> {};

TEST_P(EveryAction, StaysWithinTheJointRanges) {
  const robot::RobotModel robot = beetle();
  for (const robot::JointVector& target : record_action(GetParam()).targets) {
    for (std::size_t slot = 0; slot < robot::kJointCount; ++slot) {
      ASSERT_GE(target[slot], robot.joints[slot].min_rad) << robot::kJointNames[slot];
      ASSERT_LE(target[slot], robot.joints[slot].max_rad) << robot::kJointNames[slot];
    }
  }
}

TEST_P(EveryAction, StepsInTripods) {
  const Recording pattern = record_action(GetParam());
  const double omega = omega_of(pattern);
  for (const auto& [leg, reference] : {std::pair{Leg::kR1, Leg::kL0},
                                       {Leg::kL1, Leg::kL0},
                                       {Leg::kR0, Leg::kL0},
                                       {Leg::kR2, Leg::kL2}}) {
    const bool same = robot::tripod_sign(leg) == robot::tripod_sign(reference);
    for (const LegJoint joint : {kT, kC}) {
      const Signal signal = target(pattern, leg, joint);
      if (swing_of(signal) == 0) {
        continue;  // held at a limit of its range (hind C in soft pushing)
      }
      const double lag = lag_rad(signal, target(pattern, reference, joint), omega);
      EXPECT_NEAR(std::abs(wrap(lag - (same ? 0 : kPi))), 0, 0.12)
          << robot::kLegNames[leg_slot(leg)];
    }
  }
}

TEST_P(EveryAction, KeepsFAndBackboneFixed) {
  const Recording pattern = record_action(GetParam());
  for (const Leg leg : robot::kLegs) {
    EXPECT_EQ(swing_of(target(pattern, leg, kF)), 0);
  }
  EXPECT_EQ(pattern.targets.back()[robot::kBackboneSlot], 0.05);
}

TEST_P(EveryAction, KeepsEachFrontAndMiddleLegOnTheGroundForHalfOfThePeriod) {
  const Recording pattern = record_action(GetParam());
  for (const Leg leg : {Leg::kL0, Leg::kL1, Leg::kR0, Leg::kR1}) {
    const Signal c = target(pattern, leg, kC);
    const double low = min_of(c);
    const auto down = std::count_if(c.begin(), c.end(), [=](double a) { return a < low + 1e-9; });
    EXPECT_NEAR(static_cast<double>(down) / static_cast<double>(c.size()), 0.5, 0.1);
    EXPECT_GT(swing_of(c), 0.3) << "lifts";
  }
}

TEST_P(EveryAction, WalksWithFrontAndMiddleLegs) {
  const double expected = std::string(GetParam()) == "forward" ? 1 : -1;
  const Recording pattern = record_action(GetParam());
  for (const Leg leg : {Leg::kL0, Leg::kL1, Leg::kR0, Leg::kR1}) {
    EXPECT_GT(expected * sense(pattern, leg), 0.5) << robot::kLegNames[leg_slot(leg)];
    EXPECT_GT(swing_of(target(pattern, leg, kT)), 0.55);
  }
}

INSTANTIATE_TEST_SUITE_P(Table1, EveryAction,
                         testing::Values("forward", "backward", "soft_push", "boxing", "hard_push"),
                         [](const auto& row) { return std::string(row.param); });

TEST(MotorPattern, HindLegsWalkForwardAndBackwardWithTheOthers) {
  for (const Leg leg : {Leg::kL2, Leg::kR2}) {
    EXPECT_GT(sense(record_action("forward"), leg), 0.5);
    EXPECT_LT(sense(record_action("backward"), leg), -0.5);
  }
}

// The front and middle T-joints are late by tau, the hind ones by the four steps of PSN2.
TEST(MotorPattern, TIsLateAgainstCByAboutAQuarterOfThePeriod) {
  const Recording forward = record_action("forward");
  const Recording backward = record_action("backward");
  const double omega = omega_of(forward);
  for (const Leg leg : robot::kLegs) {
    const double ticks = robot::row(leg) == 2 ? 4 : f2_config().network.t_delay_ticks;
    const double lag = lag_rad(target(forward, leg, kT), target(forward, leg, kC), omega);
    EXPECT_NEAR(lag, ticks * omega, 0.1) << robot::kLegNames[leg_slot(leg)];
    const double turned = lag_rad(target(backward, leg, kT), target(backward, leg, kC), omega);
    EXPECT_NEAR(std::abs(wrap(turned - lag)), kPi, 0.1) << "backward: T turned round, C as before";
  }
}

TEST(MotorPattern, OnlyTheHindLegsTellThePushingModesFromBackwardWalking) {
  const Recording backward = record_action("backward");
  for (const char* name : {"soft_push", "boxing", "hard_push"}) {
    const Recording pushing = record_action(name);
    for (std::size_t i = 0; i < pushing.targets.size(); ++i) {
      for (const Leg leg : {Leg::kL0, Leg::kL1, Leg::kR0, Leg::kR1}) {
        for (const LegJoint joint : {kT, kC, kF}) {
          const std::size_t slot = joint_slot(leg, joint);
          ASSERT_NEAR(pushing.targets[i][slot], backward.targets[i][slot], 1e-6) << name;
        }
      }
    }
  }
}

TEST(MotorPattern, HindAmplitudesFollowI2AndI3) {
  const auto t_amplitude = [](const char* name) {
    return max_of(signal(record_action(name), [](const auto& s) { return s.vrn2[6]; }));
  };
  const auto c_amplitude = [](const char* name) {
    return max_of(signal(record_action(name), [](const auto& s) { return s.vrn1[6]; }));
  };
  // VRN2.V1 = tanh(0.7 + 0.3 I2): walking I2 = 1, hard 0, soft and boxing -1.
  EXPECT_GT(t_amplitude("backward"), 1.3 * t_amplitude("hard_push"));
  EXPECT_GT(t_amplitude("hard_push"), 1.8 * t_amplitude("soft_push"));
  EXPECT_NEAR(t_amplitude("soft_push"), t_amplitude("boxing"), 1e-3);
  // VRN1.V1 = tanh(1 - 0.57 I3), V2 from the CPG but in soft pushing, where it is the smaller
  // PSN1.P13.
  EXPECT_NEAR(c_amplitude("hard_push"), c_amplitude("backward"), 1e-3);
  EXPECT_GT(c_amplitude("backward"), 1.4 * c_amplitude("boxing"));
  EXPECT_GT(c_amplitude("boxing"), 3 * c_amplitude("soft_push"));
}

TEST(MotorPattern, SoftPushingRaisesAndStretchesTheHindLegsAndRollsWithTheTJoints) {
  const Recording soft = record_action("soft_push");
  const Recording hard = record_action("hard_push");
  const Recording boxing = record_action("boxing");
  for (const Leg leg : {Leg::kL2, Leg::kR2}) {
    EXPECT_GT(min_of(target(soft, leg, kC)), max_of(target(hard, leg, kC)) + 0.15) << "I4: 1, -0.3";
    EXPECT_LT(max_of(target(soft, leg, kF)), min_of(target(hard, leg, kF)) - 0.8) << "I3: 1, 0";
    EXPECT_EQ(max_of(target(soft, leg, kF)), max_of(target(boxing, leg, kF)));
    EXPECT_LT(swing_of(target(soft, leg, kC)), 0.1) << "small C motion";
    EXPECT_GT(swing_of(target(soft, leg, kT)), 0.15) << "clipped at the forward end of its range";
  }
}

TEST(MotorPattern, BoxingStrikesWithTheCJointsOfStretchedHindLegs) {
  const Recording boxing = record_action("boxing");
  for (const Leg leg : {Leg::kL2, Leg::kR2}) {
    EXPECT_GT(swing_of(target(boxing, leg, kC)), 0.4);
    EXPECT_GT(sense(boxing, leg), 0.5);
  }
}

TEST(MotorPattern, HardPushingDigsWithTheHindLegsLower) {
  const Recording hard = record_action("hard_push");
  const Recording boxing = record_action("boxing");
  for (const Leg leg : {Leg::kL2, Leg::kR2}) {
    EXPECT_GT(swing_of(target(hard, leg, kC)), 0.7);
    EXPECT_LT(min_of(target(hard, leg, kC)), min_of(target(boxing, leg, kC)) - 0.4) << "I4 = -0.3";
    EXPECT_GT(sense(hard, leg), 0.5);
  }
}

TEST(MotorPattern, StationaryHoldsTheHindLegsAndWalksBackwardWithTheOthers) {
  const Recording stationary = record_stationary();
  const Recording backward = record_action("backward");
  for (const Leg leg : robot::kLegs) {
    for (const LegJoint joint : {kT, kC, kF}) {
      const Signal held = target(stationary, leg, joint);
      if (robot::row(leg) == 2) {
        EXPECT_EQ(swing_of(held), 0);
        EXPECT_EQ(held.front(), kHindPose[static_cast<std::size_t>(joint)]);
      } else {
        EXPECT_EQ(held, target(backward, leg, joint));
      }
    }
  }
}

}  // namespace
}  // namespace scarab::premotor
