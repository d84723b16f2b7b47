#include <gmock/gmock.h>

#include <iostream>

#include "tests/support/files.hpp"
#include "tests/support/status_watch.hpp"
#include "tests/system/robot_bridge/recorded_trial.hpp"
#include "tests/system/robot_bridge/robot_stack.hpp"
#include "tests/system/stack.hpp"

namespace scarab::test {
namespace {

using testing::ElementsAre;

constexpr std::chrono::seconds kTrialLimit{90};
constexpr std::size_t kTicksOfTenSeconds = 100;
constexpr double kRmsMost_rad = 0.05;

/// The main trial with the plant, in lockstep: what it does by the wall clock, too, where every
/// command is in time.
RecordedTrial with_plant(const std::filesystem::path& directory) {
  Stack stack(directory);
  auto experiment = stack.conduct(main_trial());
  EXPECT_EQ(experiment.wait(kTrialLimit), 0) << experiment.output() << stack.errors();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  return read_recorded_trial(stack.log());
}

class Swap : public testing::Test {
 protected:
  struct Run {
    RecordedTrial trial;
    std::uint64_t commands_late = 0;
  };

  /// The same with a robot at the other end of a wire.
  Run with_robot(const std::string& name, const std::string& driver) {
    RobotStack::Options options;
    options.driver = driver;
    RobotStack stack(directory_ / name, options);
    auto experiment = stack.conduct(main_trial());
    EXPECT_EQ(experiment.wait(kTrialLimit), 0) << experiment.output() << stack.errors();
    std::cout << driver << ": " << experiment.out();
    const auto bridge = status_.await({"robot_bridge", 0}, [](const StatusWatch::Report& report) {
      return report.lifecycle == scarab_LIFECYCLE_INACTIVE && report.header.trial == 1;
    });
    EXPECT_TRUE(bridge) << stack.errors();
    EXPECT_TRUE(stack.stop()) << stack.errors();
    return {read_recorded_trial(stack.log()), bridge ? bridge->counters.at("commands_late") : 0};
  }

  TemporaryDirectory directory_;
  StatusWatch status_;
};

/// A command that comes late is applied late: another trajectory. A loaded machine has several
/// goes.
TEST_F(Swap, RobotAtAWireMovesAsThePlantDoes) {
  const RecordedTrial plant = with_plant(directory_ / "plant");
  Run robot = with_robot("robot-1", "dynamixel");
  for (int go = 2; go <= 3 && robot.commands_late > 0; ++go) {
    robot = with_robot("robot-" + std::to_string(go), "dynamixel");
  }
  const double rms_rad = rms_difference_rad(plant, robot.trial, kTicksOfTenSeconds);
  std::cout << "joint angles over the first 10 s of walking: " << rms_rad << " rad RMS apart; "
            << robot.commands_late << " commands were late\n";
  EXPECT_LT(rms_rad, kRmsMost_rad);
  EXPECT_EQ(robot.trial.behaviours, plant.behaviours);
  EXPECT_THAT(robot.trial.behaviours, ElementsAre("approach", "climb", "mode 1", "mode 2", "done"));
}

/// Positions as commanded only, 57600 baud, angles in bytes: another obstacle trigger, and another
/// way onto the object, from which it may slide once.
TEST_F(Swap, BoardWithoutAngleFeedbackDoesTheTaskToo) {
  const RecordedTrial robot = with_robot("robot", "amosii").trial;
  ASSERT_GE(robot.behaviours.size(), 5U);
  EXPECT_EQ(robot.behaviours.front(), "approach");
  const std::vector<std::string> end(robot.behaviours.end() - 4, robot.behaviours.end());
  EXPECT_THAT(end, ElementsAre("climb", "mode 1", "mode 2", "done"));
}

}  // namespace
}  // namespace scarab::test
