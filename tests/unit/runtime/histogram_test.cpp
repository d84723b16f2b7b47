#include "common/runtime/histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/bus/topics.hpp"

namespace scarab::runtime {
namespace {

using std::chrono::microseconds;
using std::chrono::nanoseconds;

static_assert(Histogram::kBuckets == scarab_HISTOGRAM_BUCKETS);
static_assert(Histogram::kBuckets == std::size(scarab_Histogram{}.count));

TEST(Histogram, EdgesRiseByLessThanAFactorOfThree) {
  const auto& edges = Histogram::kEdgesS;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    EXPECT_GT(edges[i], edges[i - 1]);
    EXPECT_LT(edges[i], 3 * edges[i - 1]);
  }
}

TEST(Histogram, ADurationFallsBetweenTheEdgesAroundIt) {
  for (std::int64_t ns = 1; ns < 100'000'000'000; ns = ns * 3 + 1) {
    Histogram histogram;
    histogram.add(nanoseconds(ns));
    const auto& counts = histogram.counts();
    const auto bucket =
        static_cast<std::size_t>(std::find(counts.begin(), counts.end(), 1U) - counts.begin());
    ASSERT_LT(bucket, Histogram::kBuckets);
    const double s = static_cast<double>(ns) * 1e-9;
    if (bucket > 0) {
      EXPECT_GE(s, Histogram::kEdgesS[bucket - 1]);
    }
    if (bucket < Histogram::kEdgesS.size()) {
      EXPECT_LT(s, Histogram::kEdgesS[bucket]);
    }
    EXPECT_EQ(histogram.total(), 1U);
  }
}

TEST(Histogram, KeepsSumAndLongest) {
  Histogram histogram;
  for (const int us : {30, 10, 20}) histogram.add(microseconds(us));
  EXPECT_NEAR(histogram.sum_s(), 60e-6, 1e-12);
  EXPECT_NEAR(histogram.max_s(), 30e-6, 1e-12);
}

TEST(Histogram, NegativeCountsAsNothing) {
  Histogram histogram;
  histogram.add(microseconds(-5));
  EXPECT_EQ(histogram.counts()[0], 1U);
  EXPECT_EQ(histogram.sum_s(), 0);
}

TEST(Histogram, QuantilesBoundTheirShareFromAbove) {
  Histogram histogram;
  for (int i = 1; i <= 100; ++i) histogram.add(microseconds(i * 7));
  for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 1.0}) {
    const double exact_s = 7e-6 * 100 * share;
    EXPECT_GE(histogram.quantile_s(share), exact_s * 0.999) << share;
    EXPECT_LE(histogram.quantile_s(share), 2.6 * exact_s) << share;
  }
  EXPECT_DOUBLE_EQ(histogram.quantile_s(1), histogram.max_s());
}

TEST(Histogram, WithoutAnyTheQuantilesAreNought) { EXPECT_EQ(Histogram().quantile_s(0.99), 0); }

}  // namespace
}  // namespace scarab::runtime
