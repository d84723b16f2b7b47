#include "tests/integration/emulator/line.hpp"

#include <gmock/gmock.h>

#include "tests/integration/emulator/emulator_process.hpp"

/// DYNAMIXEL servos as they answer on the wire.
namespace scarab::test {
namespace {

using std::chrono::microseconds;
using std::chrono::nanoseconds;

class DynamixelWire : public ::testing::Test {
 protected:
  EmulatorProcess emulator_;
  DynamixelLine line_{emulator_.device()};
};

TEST_F(DynamixelWire, AnswersAsPublished) {
  // e-Manual, Protocol 2.0: the ping of device 1; its answer but for model, firmware and CRC.
  const Bytes answer = line_.exchange({0xFF, 0xFF, 0xFD, 0, 1, 3, 0, 1, 0x19, 0x4E}, 14).bytes;
  ASSERT_EQ(answer.size(), 14U);
  EXPECT_EQ(Bytes(answer.begin(), answer.begin() + 9),
            (Bytes{0xFF, 0xFF, 0xFD, 0, 1, 7, 0, 0x55, 0}));
  // The write to device 1, and the status that answers it, byte by byte.
  EXPECT_EQ(
      line_.exchange({0xFF, 0xFF, 0xFD, 0, 1, 9, 0, 3, 0x74, 0, 0, 2, 0, 0, 0xCA, 0x89}, 11).bytes,
      (Bytes{0xFF, 0xFF, 0xFD, 0, 1, 4, 0, 0x55, 0, 0xA1, 0x0C}));
  EXPECT_TRUE(emulator_.notes(",goal,TL0 ")) << emulator_.journal();
}

/// No reply is faster than the wire: 10 bits a byte, both ways, and the servo's return delay.
TEST_F(DynamixelWire, AnswersAtTheRateOfTheBus) {
  std::vector<std::uint8_t> ids;
  for (std::uint8_t id = 1; id <= DynamixelLine::kServos; ++id) {
    ids.push_back(id);
    ASSERT_TRUE(line_.write(id, DynamixelLine::kModel.return_delay, 50));  // 100 us
  }
  const Bytes request = dxl::encode(dxl::fast_sync_read({126, 10}, ids));
  const std::size_t size = 8 + 19 * 14;  // e-Manual, "Fast Sync Read"
  const auto least = (request.size() + size) * microseconds(10) + microseconds(100);
  nanoseconds fastest = nanoseconds::max();
  for (int i = 0; i < 20; ++i) {
    const auto timed = line_.exchange(request, size);
    ASSERT_EQ(timed.bytes.size(), size) << i;
    EXPECT_GE(timed.took, least) << i;
    fastest = std::min(fastest, timed.took);
  }
  EXPECT_LT(fastest, least + std::chrono::milliseconds(3)) << "nor is it much slower";
}

TEST_F(DynamixelWire, AServoGoesWhereItIsTold) {
  const auto& model = DynamixelLine::kModel;
  constexpr std::uint8_t kMiddleLegC = 8;  // CL1: no ground holds it
  const auto before = line_.read(kMiddleLegC, model.present_position);
  ASSERT_TRUE(before);
  ASSERT_TRUE(line_.power_all());
  ASSERT_TRUE(line_.write(kMiddleLegC, model.goal_position, *before + 200));
  EXPECT_TRUE(eventually([&] {
    return std::abs(*line_.read(kMiddleLegC, model.present_position) - (*before + 200)) < 60;
  }));
}

TEST_F(DynamixelWire, TheBusWatchdogStopsAServoThatHearsNothing) {
  const auto& model = DynamixelLine::kModel;
  ASSERT_TRUE(line_.write(1, model.torque_enable, 1));
  ASSERT_TRUE(line_.write(1, model.bus_watchdog, 5));  // 100 ms
  EXPECT_TRUE(emulator_.notes(",watchdog,TL0")) << emulator_.journal();
  EXPECT_EQ(line_.read(1, model.bus_watchdog), -1);
}

}  // namespace
}  // namespace scarab::test
