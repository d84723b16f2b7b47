#include <gmock/gmock.h>

#include <limits>

#include "tests/unit/emulator/dynamixel_rig.hpp"
#include "tests/unit/emulator/suffering.hpp"

/// e-Manual, XM430-W350, "Bus Watchdog".
namespace scarab::emulator {
namespace {

using testing::DynamixelRig;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

class BusWatchdog : public ::testing::Test {
 protected:
  /// 200 ms, from the instruction at `now_ns` on; the servo is on its way from 2048 to 1024.
  void arm(std::int64_t now_ns) {
    rig.write(1, rig.model.torque_enable, 1, now_ns);
    rig.write(1, rig.model.goal_position, 1024, now_ns);
    rig.write(1, rig.model.bus_watchdog, 10, now_ns);
  }
  DynamixelRig rig;
};

TEST_F(BusWatchdog, StopsTheServoWhereItIs) {
  arm(0);
  EXPECT_EQ(rig.board->next_tick_ns(), 200 * kMs + 1);
  rig.stand_at({{1, 1500}});
  rig.board->tick(200 * kMs);
  EXPECT_NEAR(rig.board->drive().target_rad[0], rig.joint_rad(1, 1024), 1e-9);
  rig.board->tick(200 * kMs + 1);
  EXPECT_NEAR(rig.board->drive().target_rad[0], rig.joint_rad(1, 1500), 1e-9);
  EXPECT_TRUE(rig.board->drive().powered[0]) << "it holds";
  EXPECT_THAT(rig.noted("watchdog"), ElementsAre("TL0"));
  EXPECT_EQ(rig.board->next_tick_ns(), kNever);
  EXPECT_EQ(rig.read(1, rig.model.bus_watchdog), -1);
}

TEST_F(BusWatchdog, AnyInstructionOnTheBusKeepsItQuiet) {
  arm(0);
  for (std::int64_t now = 150 * kMs; now < 1000 * kMs; now += 150 * kMs) {
    rig.say(dxl::ping(7), now);
    rig.board->tick(now + 149 * kMs);
  }
  EXPECT_THAT(rig.noted("watchdog"), IsEmpty());
}

TEST_F(BusWatchdog, NoiseIsNoInstruction) {
  arm(0);
  rig.say(testing::hex("FF FF FD 00 01 03 00 01 19 4F"), 150 * kMs);
  rig.say(testing::hex("55 AA 00"), 180 * kMs);
  rig.board->tick(201 * kMs);
  EXPECT_THAT(rig.noted("watchdog"), ElementsAre("TL0"));
}

TEST_F(BusWatchdog, RefusesGoalsUntilItIsCleared) {
  arm(0);
  rig.board->tick(300 * kMs);
  EXPECT_EQ(rig.write(1, rig.model.goal_position, 1100, 301 * kMs), dxl::StatusError::kDataRange);
  rig.say(dxl::sync_write({{116, 4}, {{1, {0, 8, 0, 0}}}}), 302 * kMs);
  EXPECT_EQ(rig.read(1, rig.model.goal_position, 303 * kMs), 1024);
  EXPECT_EQ(rig.write(1, rig.model.bus_watchdog, 0, 304 * kMs), dxl::StatusError::kNone);
  EXPECT_EQ(rig.write(1, rig.model.goal_position, 1100, 305 * kMs), dxl::StatusError::kNone);
  rig.board->tick(10'000 * kMs);
  EXPECT_NEAR(rig.board->drive().target_rad[0], rig.joint_rad(1, 1100), 1e-9) << "it is off";
}

TEST_F(BusWatchdog, WatchesOnlyUnderTorque) {
  rig.write(1, rig.model.bus_watchdog, 10, 0);
  EXPECT_EQ(rig.board->next_tick_ns(), kNever);
  rig.board->tick(10'000 * kMs);
  EXPECT_EQ(rig.read(1, rig.model.bus_watchdog, 10'000 * kMs), 10);
}

TEST_F(BusWatchdog, AServoThatHearsNothingStops) {
  arm(0);
  rig.board->suffer(testing::suffering("silent TL0"));
  rig.say(dxl::ping(7), 150 * kMs);
  rig.board->tick(201 * kMs);
  EXPECT_THAT(rig.noted("watchdog"), ElementsAre("TL0"));
}

}  // namespace
}  // namespace scarab::emulator
