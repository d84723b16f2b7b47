#include "common/bus/line_limit.hpp"

#include <gtest/gtest.h>

namespace scarab::bus {
namespace {

using std::chrono::milliseconds;

LineLimit::TimePoint at(int ms) { return LineLimit::TimePoint(milliseconds(1'000'000 + ms)); }

TEST(LineLimit, ALineNowAndThenAlwaysPasses) {
  LineLimit limit(5);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(limit.admit(at(i * 250)), 0U);
}

TEST(LineLimit, OfAFloodItLetsThroughWhatASecondMayHave) {
  LineLimit limit(5);
  unsigned passed = 0;
  for (int ms = 0; ms < 10'000; ++ms) passed += limit.admit(at(ms)) ? 1U : 0U;
  EXPECT_EQ(passed, 50U);
}

TEST(LineLimit, SaysHowManyItLeftOut) {
  LineLimit limit(2);
  std::uint64_t passed = 0, left_out = 0;
  for (int ms = 0; ms < 3'001; ++ms) {
    if (const auto before = limit.admit(at(ms))) {
      ++passed;
      left_out += *before;
    }
  }
  EXPECT_EQ(passed + left_out, 3'001U);  // the last one passes and accounts for all before it
}

}  // namespace
}  // namespace scarab::bus
