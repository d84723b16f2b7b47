#include "services/supervisor/core/signals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scarab::supervisor {
namespace {

constexpr double kTwoPi = 6.283185307179586476925;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ExponentialMean, ApproachesAStepGeometrically) {
  ExponentialMean mean;
  for (int n = 1; n <= 20; ++n) {
    EXPECT_NEAR(update(mean, 1, 0.2), 1 - std::pow(0.8, n), 1e-12);
  }
}

TEST(ExponentialMean, PassesOverSamplesThatAreNotFinite) {
  ExponentialMean mean;
  update(mean, 1, 0.2);
  const double before = mean.value;
  EXPECT_EQ(update(mean, kNan, 0.2), before);
  EXPECT_EQ(update(mean, HUGE_VAL, 0.2), before);
}

TEST(MovingWindow, AveragesWholeSamples) {
  MovingWindow window;
  for (const double sample : {10.0, 1.0, 2.0, 6.0}) {
    push(window, sample);
  }
  EXPECT_DOUBLE_EQ(mean(window, 3), 3);
  EXPECT_DOUBLE_EQ(mean(window, 1), 6);
}

TEST(MovingWindow, WeighsTheOldestSampleByTheFraction) {
  MovingWindow window;
  for (const double sample : {10.0, 1.0, 2.0, 6.0}) {
    push(window, sample);
  }
  EXPECT_DOUBLE_EQ(mean(window, 3.5), (6 + 2 + 1 + 0.5 * 10) / 3.5);
}

TEST(MovingWindow, OfFewerSamplesThanItsWidthAveragesThese) {
  MovingWindow window;
  EXPECT_EQ(mean(window, 14.4), 0);
  push(window, 4);
  push(window, 2);
  EXPECT_DOUBLE_EQ(mean(window, 14.4), 3);
}

TEST(MovingWindow, CoversAWidthFromItsRoundedUpNumberOfSamples) {
  MovingWindow window;
  for (int i = 0; i < 14; ++i) {
    push(window, 1);
  }
  EXPECT_TRUE(covers(window, 14));
  EXPECT_FALSE(covers(window, 14.4));
  push(window, 1);
  EXPECT_TRUE(covers(window, 14.4));
}

TEST(MovingWindow, KeepsAConstantExactlyForAnyWidth) {
  for (const double width : {1.0, 7.3, 14.43, 63.9, 64.0}) {
    MovingWindow window;
    for (int i = 0; i < 300; ++i) {
      push(window, 1.013);
    }
    EXPECT_NEAR(mean(window, width), 1.013, 1e-14) << width;
  }
}

TEST(MovingWindow, ForgetsWhatIsOlderThanItsWidth) {
  MovingWindow window;
  for (int i = 0; i < 1000; ++i) {
    push(window, i % 7);
  }
  for (int i = 0; i < 15; ++i) {
    push(window, 0.5);
  }
  EXPECT_DOUBLE_EQ(mean(window, 14.4), 0.5);
}

TEST(MovingWindow, PassesOverSamplesThatAreNotFinite) {
  MovingWindow window;
  push(window, 1);
  push(window, kNan);
  EXPECT_EQ(mean(window, 2), 1);
}

/// Largest deviation from the mean of a sine of period `period` (in ticks) and amplitude 1 in a
/// window of `width`.
double ripple(double period, double width) {
  MovingWindow window;
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    push(window, std::sin(kTwoPi * i / period));
    if (i > 100) {
      worst = std::max(worst, std::abs(mean(window, width)));
    }
  }
  return worst;
}

TEST(MovingWindow, CancelsARippleOfItsOwnWidth) {
  EXPECT_LT(ripple(14, 14), 1e-12) << "whole periods exactly";
  EXPECT_LT(ripple(14.43, 14.43), 0.005);
  EXPECT_LT(ripple(14.43 / 2, 14.43), 0.01)
      << "and its second harmonic: two steps of a tripod gait";
}

TEST(MovingWindow, OfAnotherWidthLeavesARipple) {
  EXPECT_GT(ripple(14.43, 10), 0.2);
  EXPECT_GT(ripple(14.43, 14), 4 * ripple(14.43, 14.43));
}

}  // namespace
}  // namespace scarab::supervisor
