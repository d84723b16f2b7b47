#include "services/supervisor/core/strategy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/unit/supervisor/scripted_robot.hpp"

namespace scarab::supervisor {
namespace {

/// A strategy of the paper's second experiment.
struct Row {
  const char* name;
  Mode mode_1;
  Mode mode_2;  ///< kStop: none
};

class PaperStrategy : public testing::TestWithParam<Row> {};

TEST_P(PaperStrategy, RunsItsModesInOrder) {
  const Row& row = GetParam();
  ScriptedRobot robot(row.name);
  EXPECT_EQ(robot.tick().mode, Mode::kBackward);
  robot.pitch_rad = 0.18;
  const Decision mode_1 = robot.until(State::kMode1);
  EXPECT_EQ(mode_1.mode, row.mode_1);
  robot.front_f_rad = 0.9;
  const Decision later = robot.ticks(100);
  const bool switches = row.mode_2 != Mode::kStop;
  EXPECT_EQ(later.state, switches ? State::kMode2 : State::kMode1);
  EXPECT_EQ(later.mode, switches ? row.mode_2 : row.mode_1);
}

TEST_P(PaperStrategy, HoldsTheHindLegsInStationaryModeOnly) {
  ScriptedRobot robot(GetParam().name);
  EXPECT_FALSE(robot.tick().hind_override);
  robot.pitch_rad = 0.18;
  const Decision mode_1 = robot.until(State::kMode1);
  const bool stationary = GetParam().mode_1 == Mode::kStationary;
  EXPECT_EQ(mode_1.hind_override, stationary);
  EXPECT_EQ(mode_1.hind_pose_rad,
            stationary ? f2_config().stationary_hind_pose_rad : (std::array<double, 3>{}));
  robot.front_f_rad = 0.9;
  const Decision later = robot.ticks(100);
  EXPECT_EQ(later.hind_override, later.mode == Mode::kStationary);
}

INSTANTIATE_TEST_SUITE_P(All, PaperStrategy,
                         testing::Values(Row{"soft", Mode::kSoftPush, Mode::kStop},
                                         Row{"boxing", Mode::kBoxing, Mode::kStop},
                                         Row{"stationary", Mode::kStationary, Mode::kStop},
                                         Row{"soft+hard", Mode::kSoftPush, Mode::kHardPush},
                                         Row{"boxing+hard", Mode::kBoxing, Mode::kHardPush},
                                         Row{"stationary+hard", Mode::kStationary, Mode::kHardPush},
                                         Row{"hard", Mode::kHardPush, Mode::kStop}));

TEST(Strategy, WalkingKeepsItsModeWhateverTheSensorsSay) {
  for (const auto& [name, mode] : {std::pair{"walk-forward", Mode::kForward},
                                   {"walk-backward", Mode::kBackward},
                                   {"stand", Mode::kStop}}) {
    ScriptedRobot robot(name);
    robot.pitch_rad = 0.4;
    robot.front_f_rad = 0.5;
    const Decision decision = robot.ticks(200);
    EXPECT_EQ(decision.state, State::kApproach) << name;
    EXPECT_EQ(decision.mode, mode) << name;
  }
}

TEST(Strategy, UnknownNameIsAnsweredWithTheNames) {
  try {
    (void)find_strategy(f2_config(), "soft-hard");
    FAIL() << "found";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("unknown strategy 'soft-hard'"));
    for (const char* name : {"soft", "boxing", "stationary", "soft+hard", "boxing+hard",
                             "stationary+hard", "walk-forward", "stand"}) {
      EXPECT_THAT(error.what(), testing::HasSubstr(name));
    }
  }
}

// Paper, Table 1.
TEST(Strategy, InputsAreThoseOfTable1) {
  using I = std::array<double, 4>;
  const SupervisorConfig config = f2_config();
  EXPECT_EQ(inputs_of(config, Mode::kForward), (I{1, 1, 0, 0}));
  EXPECT_EQ(inputs_of(config, Mode::kBackward), (I{0, 1, 0, 0}));
  EXPECT_EQ(inputs_of(config, Mode::kSoftPush), (I{1, -1, 1, 1}));
  EXPECT_EQ(inputs_of(config, Mode::kBoxing), (I{-1, -1, 1, 0}));
  EXPECT_EQ(inputs_of(config, Mode::kHardPush), (I{1, 0, 0, -0.3}));
  EXPECT_EQ(inputs_of(config, Mode::kStationary), inputs_of(config, Mode::kBackward));
}

}  // namespace
}  // namespace scarab::supervisor
