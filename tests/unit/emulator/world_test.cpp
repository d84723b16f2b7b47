#include "tools/emulator/world/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "common/config/robot_file.hpp"
#include "services/plant/config.hpp"

namespace scarab::emulator {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::size_t kMiddleC =
    robot::joint_slot(robot::Leg::kL1, robot::LegJoint::kCoxaTrochanteral);
using Joints = std::bitset<robot::kJointCount>;

std::filesystem::path source_file(const char* relative) {
  return std::filesystem::path(SCARAB_SOURCE_DIR) / relative;
}

World beetle_world() {
  return {config::load_robot(source_file("config/robot/beetle.yaml")),
          plant::load_config(source_file("config/plant/beetle.yaml")), 0.02};
}

class WorldTest : public ::testing::Test {
 protected:
  WorldTest() {
    drive.target_rad = world.configured_start_rad();
    drive.powered.set();
  }
  /// As the emulator does it, every 2 ms.
  void run(std::int64_t from_ns, std::int64_t to_ns, Joints stuck = {}) {
    for (std::int64_t now = from_ns; now <= to_ns; now += 2 * kMs) {
      world.advance(now, drive, stuck, [this] { sampled_ns.push_back(world.time_ns()); });
    }
  }

  World world = beetle_world();
  Drive drive;
  std::vector<std::int64_t> sampled_ns;
};

TEST_F(WorldTest, StandsStillUntilItIsStarted) {
  const auto before = world.observe().position_rad;
  drive.powered.reset();
  run(0, 1000 * kMs);
  EXPECT_EQ(world.time_ns(), 0);
  EXPECT_EQ(world.observe().position_rad, before);
}

TEST_F(WorldTest, MovesByTheClockThatIsGiven) {
  world.start(5000 * kMs);
  run(5000 * kMs, 5100 * kMs);
  EXPECT_EQ(world.time_ns(), 100 * kMs);
  EXPECT_EQ(sampled_ns,
            (std::vector<std::int64_t>{20 * kMs, 40 * kMs, 60 * kMs, 80 * kMs, 100 * kMs}));
  EXPECT_EQ(world.next_step_ns(), 5102 * kMs);
  EXPECT_EQ(world.lateness().count, 0U);
}

TEST_F(WorldTest, CatchesUpALittleAndLeavesOutTheRest) {
  const auto sample = [] {};
  world.start(0);
  world.advance(80 * kMs, drive, {}, sample);
  EXPECT_EQ(world.time_ns(), 80 * kMs) << "caught up with";
  EXPECT_EQ(world.lateness().count, 0U);
  world.advance(1080 * kMs, drive, {}, sample);
  EXPECT_LT(world.time_ns(), 200 * kMs);
  EXPECT_EQ(world.lateness().count, 1U);
  EXPECT_NEAR(static_cast<double>(world.lateness().lost_ns), 1000.0 * kMs, 100.0 * kMs);
  const std::int64_t then = world.time_ns();
  world.advance(1100 * kMs, drive, {}, sample);
  EXPECT_EQ(world.time_ns(), then + 20 * kMs) << "on from there";
}

TEST_F(WorldTest, AStuckJointHoldsWhereItIs) {
  world.start(0);
  run(0, 200 * kMs);
  const double at_rad = world.observe().position_rad[kMiddleC];
  drive.target_rad[kMiddleC] += 0.4;
  run(200 * kMs, 700 * kMs, Joints().set(kMiddleC));
  EXPECT_NEAR(world.observe().position_rad[kMiddleC], at_rad, 0.1);
  run(700 * kMs, 1200 * kMs);
  EXPECT_GT(world.observe().position_rad[kMiddleC], at_rad + 0.25) << "and goes on when it can";
}

TEST_F(WorldTest, AJointWithoutPowerIsLimp) {
  world.start(0);
  drive.target_rad[kMiddleC] += 0.4;
  run(0, 600 * kMs);
  const double raised_rad = world.observe().position_rad[kMiddleC];
  drive.powered.reset(kMiddleC);
  run(600 * kMs, 1500 * kMs);
  EXPECT_LT(world.observe().position_rad[kMiddleC], raised_rad - 0.2);
  EXPECT_EQ(world.observe().torque_nm[kMiddleC], 0);
}

TEST_F(WorldTest, IsBuiltAnewForATrial) {
  world.start(0);
  run(0, 100 * kMs);
  plant::TrialSpec trial;
  trial.obstacle_height_m = 0.1;
  robot::JointVector start_rad = world.configured_start_rad();
  start_rad[kMiddleC] += 0.3;
  world.build(trial, start_rad);
  EXPECT_EQ(world.time_ns(), 0);
  EXPECT_FALSE(world.runs());
  EXPECT_TRUE(world.truth().obstacle_present);
  EXPECT_NEAR(world.observe().position_rad[kMiddleC], start_rad[kMiddleC], 0.1);
}

TEST_F(WorldTest, ATrialThatCannotBeLeavesItAsItWas) {
  world.start(0);
  run(0, 100 * kMs);
  plant::TrialSpec trial;
  trial.friction_scale = -1;
  EXPECT_THROW(world.build(trial, world.configured_start_rad()), std::invalid_argument);
  EXPECT_TRUE(world.runs());
  EXPECT_EQ(world.time_ns(), 100 * kMs);
}

TEST_F(WorldTest, AMotionWithoutSenseStandsStill) {
  world.start(0);
  drive.target_rad[kMiddleC] = std::nan("");
  EXPECT_THROW(run(0, 100 * kMs), std::runtime_error);
  EXPECT_FALSE(world.runs());
}

}  // namespace
}  // namespace scarab::emulator
