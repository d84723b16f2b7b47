#include <gmock/gmock.h>

#include <cmath>

#include "services/robot_bridge/drivers/serial/serial_error.hpp"
#include "tests/integration/emulator/emulator_process.hpp"
#include "tests/integration/emulator/line.hpp"

/// Each fault as it shows on the wire.
namespace scarab::test {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

constexpr milliseconds kSilence{100};  // an answer takes 1 ms

class Faults : public ::testing::Test {
 protected:
  [[nodiscard]] bool answers(std::uint8_t id) { return line_.ask(dxl::ping(id)).has_value(); }
  [[nodiscard]] bool is_silent(std::uint8_t id) {
    return !line_.ask(dxl::ping(id), kSilence).has_value();
  }

  static constexpr std::uint8_t kImu = 200;
  const dxl::ServoModel& model_ = DynamixelLine::kModel;
  EmulatorProcess emulator_;
  DynamixelLine line_{emulator_.device()};
};

TEST_F(Faults, LostAndFlippedBytes) {
  emulator_.tell("lose 1");
  EXPECT_TRUE(is_silent(1));
  emulator_.tell("clear");
  EXPECT_TRUE(answers(1));
  emulator_.tell("flip 1");
  EXPECT_TRUE(is_silent(1)) << "no packet is whole";
  EXPECT_TRUE(emulator_.notes("fault_on,flip 1"));
  emulator_.tell("clear");
  EXPECT_TRUE(answers(1));
}

TEST_F(Faults, SilentServosAndBoards) {
  emulator_.tell("silent TL1");
  EXPECT_TRUE(is_silent(2));
  EXPECT_TRUE(answers(1));
  emulator_.tell("silent imu");
  EXPECT_TRUE(is_silent(kImu));
  emulator_.tell("silent board");
  EXPECT_TRUE(is_silent(1));
  emulator_.tell("clear");
  EXPECT_TRUE(answers(1) && answers(2) && answers(kImu));
}

TEST_F(Faults, LateAnswers) {
  emulator_.tell("late 0.2");
  const auto timed = line_.exchange(dxl::encode(dxl::ping(1)), 14);
  EXPECT_EQ(timed.bytes.size(), 14U);
  EXPECT_GE(timed.took, milliseconds(200));
}

TEST_F(Faults, AStuckServoHoldsWhereItIs) {
  constexpr std::uint8_t kCl1 = 8;
  ASSERT_TRUE(line_.power_all());
  emulator_.tell("stuck CL1");
  const auto before = line_.read(kCl1, model_.present_position);
  ASSERT_TRUE(before && line_.write(kCl1, model_.goal_position, *before + 200));
  EXPECT_EQ(line_.read(kCl1, model_.goal_position), *before + 200) << "it has heard of it";
  const auto until = Line::Clock::now() + milliseconds(500);
  while (Line::Clock::now() < until) {
    ASSERT_NEAR(static_cast<double>(*line_.read(kCl1, model_.present_position)),
                static_cast<double>(*before), 40);
  }
  emulator_.tell("clear");
  EXPECT_TRUE(
      eventually([&] { return *line_.read(kCl1, model_.present_position) > *before + 100; }));
}

TEST_F(Faults, HeatCurrentAndTilt) {
  ASSERT_TRUE(line_.write(1, model_.torque_enable, 1));
  emulator_.tell("current TL0 2");
  EXPECT_GT(std::abs(*line_.read(1, model_.present_current)), 700) << "2 A of 2.69 mA";
  const dxl::Item pitch{100, dxl::Type::kF32, 1};  // config/robot_bridge/beetle-dynamixel.yaml
  const auto pitch_rad = [&] {
    return dxl::value_in(pitch, line_.ask(dxl::read(kImu, pitch.region()))->data);
  };
  const double level_rad = pitch_rad();
  emulator_.tell("tilt -0.5");
  EXPECT_NEAR(pitch_rad(), level_rad - 0.5, 0.1);
  emulator_.tell("hot TL0 90");
  const auto hot = line_.ask(dxl::read(1, model_.present_temperature.region()));
  ASSERT_TRUE(hot);
  EXPECT_EQ(hot->data.at(0), 90);
  EXPECT_TRUE(hot->alert);
  EXPECT_TRUE(emulator_.notes(",torque_off,TL0"));
}

TEST_F(Faults, UnpluggedAndPluggedInAgain) {
  emulator_.tell("unplug");
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(emulator_.device())));
  try {
    line_.send(dxl::encode(dxl::ping(1)));
    (void)line_.receive(1, kSilence);
    FAIL() << "the line is still there";
  } catch (const bridge::serial::SerialError& gone) {
    EXPECT_EQ(gone.fault(), bridge::serial::Fault::kUnplugged) << gone.what();
  }
  emulator_.tell("clear");
  DynamixelLine again(emulator_.device());
  EXPECT_TRUE(again.ask(dxl::ping(1)));
}

TEST_F(Faults, OrdersThatAreNone) {
  const Arguments tell = {program("scarab-emulator"), "tell"};
  const auto with = [&](std::initializer_list<std::string> words) {
    Arguments all = tell;
    all.insert(all.end(), words);
    return run(all);
  };
  const Finished wrong = with({emulator_.run_dir(), "stuck", "TX9"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("there is no joint 'TX9'"));
  const Finished nobody = with({"/nonexistent", "unplug"});
  EXPECT_EQ(nobody.exit_code, 1);
  EXPECT_THAT(nobody.err, HasSubstr("no emulator listens at /nonexistent"));
}

TEST(FaultsOnTime, ComeWhenTheWorldIsSoOld) {
  EmulatorProcess emulator("dynamixel", {"--fault", "silent TL0 at 0.5 for 0.5"});
  DynamixelLine line(emulator.device());
  ASSERT_TRUE(line.ask(dxl::ping(1)));
  EXPECT_EQ(emulator.journal().find("fault_on"), std::string::npos) << "the world stands still";
  ASSERT_TRUE(line.write(1, DynamixelLine::kModel.torque_enable, 1));
  EXPECT_TRUE(emulator.notes(",fault_on,silent TL0 at 0.5 for 0.5"));
  EXPECT_TRUE(emulator.notes(",fault_off,silent TL0 at 0.5 for 0.5"));
  EXPECT_TRUE(line.ask(dxl::ping(1)));
}

}  // namespace
}  // namespace scarab::test
