#include "common/runtime/clock_watch.hpp"

#include <gtest/gtest.h>

namespace scarab::runtime {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(ClockWatch, SaysNothingWhileBothClocksRunAlike) {
  ClockWatch watch;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(watch.look(hours(400'000) + milliseconds(100 * i), milliseconds(100 * i)));
  }
}

TEST(ClockWatch, SaysOnceByHowMuchItWasSet) {
  ClockWatch watch;
  EXPECT_FALSE(watch.look(seconds(1000), seconds(1)));
  EXPECT_EQ(watch.look(seconds(1061), seconds(2)), seconds(60));
  EXPECT_FALSE(watch.look(seconds(1062), seconds(3)));
  EXPECT_EQ(watch.look(seconds(1003), seconds(4)), seconds(-60));
}

TEST(ClockWatch, BearsSlewing) {
  ClockWatch watch;
  std::chrono::nanoseconds system = seconds(1000);
  for (int i = 0; i < 10'000; ++i) {
    system += milliseconds(100) + std::chrono::microseconds(50);  // 500 ppm, the most there is
    EXPECT_FALSE(watch.look(system, milliseconds(100 * i)));
  }
}

}  // namespace
}  // namespace scarab::runtime
