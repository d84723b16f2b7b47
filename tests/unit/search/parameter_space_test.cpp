#include "tools/search/parameter_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/config/scalar.hpp"

namespace scarab::search {
namespace {

TEST(Fold, LeavesTheIntervalAlone) {
  for (const double x : {0.0, 0.25, 0.5, 1.0}) EXPECT_EQ(fold(x), x);
}

TEST(Fold, MirrorsAtBothEnds) {
  EXPECT_DOUBLE_EQ(fold(1.2), 0.8);
  EXPECT_DOUBLE_EQ(fold(-0.3), 0.3);
  EXPECT_DOUBLE_EQ(fold(2.3), 0.3);
  for (double x = -7; x < 7; x += 0.01) {
    EXPECT_GE(fold(x), 0);
    EXPECT_LE(fold(x), 1);
    EXPECT_NEAR(fold(x), fold(x + 1e-9), 2e-9) << "no jump at " << x;
  }
}

TEST(ParameterSpace, StartsAtTheBaseAndComesBackToIt) {
  const ParameterSpace space({{"a", -1, 3, 0.5}, {"b", 10, 20, 20}});
  EXPECT_EQ(space.values(space.start_point()), (std::vector<double>{0.5, 20}));
}

TEST(ParameterSpace, NeverLeavesTheIntervals) {
  const ParameterSpace space({{"a", 0.12345, 0.6789, 0.2}});
  for (double x = -3; x < 3; x += 0.0173) {
    const double value = space.values({x})[0];
    EXPECT_GE(value, 0.12345);
    EXPECT_LE(value, 0.6789);
  }
}

TEST(ParameterSpace, RoundsToShortDecimalsWithinATwoThousandthOfTheInterval) {
  const ParameterSpace space({{"a", -1.3, -0.4, -0.865}});
  for (double x = 0; x <= 1; x += 0.0137) {
    const double value = space.values({x})[0];
    EXPECT_NEAR(value, -1.3 + 0.9 * x, 0.9 / 2000);
    EXPECT_LE(config::format_number(value).size(), 7U) << "-0.1234 is the longest";
  }
}

}  // namespace
}  // namespace scarab::search
