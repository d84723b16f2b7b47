#include <gmock/gmock.h>

#include <iostream>

#include "tests/support/files.hpp"
#include "tests/system/robot_bridge/recorded_trial.hpp"
#include "tests/system/robot_bridge/robot_stack.hpp"
#include "tests/system/stack.hpp"

namespace scarab::test {
namespace {

using testing::ElementsAre;

constexpr std::chrono::seconds kTrialLimit{90};
constexpr std::size_t kTicksOfTenSeconds = 100;
constexpr double kRmsMost_rad = 0.05;

/// The main trial with the plant, by the wall clock.
RecordedTrial with_plant(const std::filesystem::path& directory) {
  Stack::Options options;
  options.real_time = true;
  Stack stack(directory, options);
  auto experiment = stack.conduct(main_trial());
  EXPECT_EQ(experiment.wait(kTrialLimit), 0) << experiment.output() << stack.errors();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  return read_recorded_trial(stack.log());
}

/// The same with a robot at the other end of a wire.
RecordedTrial with_robot(const std::filesystem::path& directory, const std::string& driver) {
  RobotStack::Options options;
  options.driver = driver;
  RobotStack stack(directory, options);
  auto experiment = stack.conduct(main_trial());
  EXPECT_EQ(experiment.wait(kTrialLimit), 0) << experiment.output() << stack.errors();
  std::cout << driver << ": " << experiment.out();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  return read_recorded_trial(stack.log());
}

class Swap : public testing::Test {
 protected:
  TemporaryDirectory directory_;
};

/// One after the other: each has a machine of two cores to itself.
TEST_F(Swap, RobotAtAWireMovesAsThePlantDoes) {
  const RecordedTrial plant = with_plant(directory_ / "plant");
  const RecordedTrial robot = with_robot(directory_ / "robot", "dynamixel");
  const double rms_rad = rms_difference_rad(plant, robot, kTicksOfTenSeconds);
  std::cout << "joint angles over the first 10 s of walking: " << rms_rad << " rad RMS apart\n";
  EXPECT_LT(rms_rad, kRmsMost_rad);
  EXPECT_EQ(robot.behaviours, plant.behaviours);
  EXPECT_THAT(robot.behaviours, ElementsAre("approach", "climb", "mode 1", "mode 2", "done"));
}

/// Positions as commanded only, 57600 baud, angles in bytes: another obstacle trigger, and another
/// way onto the object, from which it may slide once.
TEST_F(Swap, BoardWithoutAngleFeedbackDoesTheTaskToo) {
  const RecordedTrial robot = with_robot(directory_ / "robot", "amosii");
  ASSERT_GE(robot.behaviours.size(), 5U);
  EXPECT_EQ(robot.behaviours.front(), "approach");
  const std::vector<std::string> end(robot.behaviours.end() - 4, robot.behaviours.end());
  EXPECT_THAT(end, ElementsAre("climb", "mode 1", "mode 2", "done"));
}

}  // namespace
}  // namespace scarab::test
