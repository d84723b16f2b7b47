#include <gmock/gmock.h>

#include "services/robot_bridge/drivers/amosii/protocol/frames.hpp"
#include "tests/integration/emulator/emulator_process.hpp"
#include "tests/integration/emulator/line.hpp"
#include "tests/integration/emulator/world_sight.hpp"

/// AMOS II's board as it answers on the wire.
namespace scarab::test {
namespace {

using std::chrono::microseconds;

class AmosiiWire : public ::testing::Test {
 protected:
  EmulatorProcess emulator_{"amosii"};
  Line line_{emulator_.device(), 57600};
};

TEST_F(AmosiiWire, AnswersAGetAtTheRateOfTheLine) {
  for (int i = 0; i < 5; ++i) {
    const auto timed = line_.exchange({2, 0}, 33);
    ASSERT_EQ(timed.bytes.size(), 33U);
    EXPECT_EQ(timed.bytes.back(), 0);
    EXPECT_GE(timed.took, microseconds(6076)) << "35 bytes of 10 bits at 57600 baud";
  }
  // Whatever follows a get belongs to nobody.
  EXPECT_EQ(line_.exchange({2, 0, 99, 7, 31}, 33).bytes.size(), 33U);
  EXPECT_TRUE(line_.receive(1, std::chrono::milliseconds(50)).empty());
}

/// From the first set on the servos have power and the world runs; feet and inclinometer tell.
TEST_F(AmosiiWire, ASetMovesTheRobot) {
  WorldSight sight;
  ASSERT_TRUE(eventually([&] { return sight.is_met(); }));
  sight.tell_trial(1);
  const auto at_start = sight.first_of(1);
  ASSERT_TRUE(at_start);
  // Every servo in the middle of its travel (tests/unit/robot_bridge/amosii/frames_test.cpp).
  line_.send({1,   125, 128, 128, 128, 128, 128, 128, 128, 115, 97, 126, 124, 140, 151, 128, 128,
              128, 128, 140, 160, 126, 124, 115, 95,  151, 124, 96, 115, 126, 140, 128, 128, 0});
  const auto later = sight.await([](const auto& seen) { return seen.header.tick >= 10; });
  ASSERT_TRUE(later) << emulator_.child().err();
  EXPECT_GT(std::abs(later->trunk_height_m - at_start->trunk_height_m), 0.005)
      << "it stands another way";
  const Bytes reply = line_.exchange({2, 0}, 33).bytes;
  ASSERT_EQ(reply.size(), 33U);
  int loaded = 0;
  for (const auto& [slot, unloaded] :
       {std::pair{14, 40}, {12, 30}, {10, 40}, {13, 15}, {11, 60}, {9, 30}}) {
    loaded += reply[static_cast<std::size_t>(slot - 1)] > unloaded ? 1 : 0;
  }
  EXPECT_GE(loaded, 3) << "feet carry the robot";
}

}  // namespace
}  // namespace scarab::test
