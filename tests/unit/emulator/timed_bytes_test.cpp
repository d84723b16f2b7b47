#include "tools/emulator/wire/timed_bytes.hpp"

#include <gtest/gtest.h>

namespace scarab::emulator {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::size_t arrived(TimedBytes& line, std::int64_t now_ns) {
  std::size_t count = 0;
  while (line.take(now_ns)) ++count;
  return count;
}

TEST(LineRate, IsTenBitsAByte) {
  EXPECT_EQ(LineRate(1'000'000).time_ns(100), 1'000'000);
  // 33 bytes at 57600 baud: 5.7292 ms, never rounded to less.
  EXPECT_EQ(LineRate(57600).time_ns(33), 5'729'167);
  EXPECT_EQ(LineRate(0).time_ns(1000), 0);
}

TEST(TimedBytes, ArriveOneByOneAtTheRate) {
  TimedBytes line(LineRate(1'000'000));
  EXPECT_EQ(line.send(Bytes{1, 2, 3}, 5'000), 35'000);
  EXPECT_EQ(arrived(line, 14'999), 0U);
  const auto first = line.take(15'000);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->byte, 1);
  EXPECT_EQ(first->time_ns, 15'000);
  EXPECT_EQ(arrived(line, 34'999), 1U);
  EXPECT_EQ(arrived(line, 35'000), 1U);
}

TEST(TimedBytes, WaitForThoseBeforeThem) {
  TimedBytes line(LineRate(1'000'000));
  EXPECT_EQ(line.send(Bytes(10), 0), 100'000);
  EXPECT_EQ(line.send(Bytes(1), 50'000), 110'000);
  EXPECT_EQ(line.send(Bytes(1), 500'000), 510'000) << "the line was free again";
  EXPECT_EQ(arrived(line, 110'000), 11U);
}

TEST(TimedBytes, AFrameIsWorthOneWakeUp) {
  TimedBytes line(LineRate(1'000'000));
  EXPECT_FALSE(line.frame_end_ns());
  line.send(Bytes(10), 0);
  line.send(Bytes(10), 0);
  EXPECT_EQ(line.frame_end_ns(), 100'000);
  EXPECT_EQ(arrived(line, 95'000), 9U);
  EXPECT_EQ(line.frame_end_ns(), 100'000);
  EXPECT_EQ(arrived(line, 100'000), 1U);
  EXPECT_EQ(line.frame_end_ns(), 200'000);
  line.clear();
  EXPECT_FALSE(line.frame_end_ns());
  EXPECT_EQ(line.send(Bytes(1), 0), 10'000) << "the line is free";
}

TEST(TimedBytes, NothingIsNoFrame) {
  TimedBytes line(LineRate(9600));
  line.send(Bytes{}, 100);
  EXPECT_FALSE(line.frame_end_ns());
  EXPECT_FALSE(line.take(1'000'000'000));
}

}  // namespace
}  // namespace scarab::emulator
