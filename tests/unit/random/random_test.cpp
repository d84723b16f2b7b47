#include "common/random/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace scarab::random {
namespace {

constexpr std::uint64_t kStream = stream("test");
constexpr std::size_t kSamples = 200'000;

using Draw = double (*)(std::uint64_t, std::uint64_t, std::uint64_t);

std::vector<double> draws(Draw draw, std::uint64_t seed, std::uint64_t from) {
  std::vector<double> values;
  for (std::uint64_t i = 0; i < kSamples; ++i) values.push_back(draw(seed, from, i));
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Mean of (x - mean x)(y[lag..] - mean y), over the standard deviations: 0 for independent series.
double correlation(const std::vector<double>& x, const std::vector<double>& y, std::size_t lag) {
  const double mean_x = mean(x);
  const double mean_y = mean(y);
  double xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i + lag < x.size(); ++i) {
    const double dx = x[i] - mean_x;
    const double dy = y[i + lag] - mean_y;
    xy += dx * dy;
    xx += dx * dx;
    yy += dy * dy;
  }
  return xy / std::sqrt(xx * yy);
}

// 5 standard errors of a correlation, or of a mean of unit variance, over kSamples.
const double kFiveSigma = 5.0 / std::sqrt(static_cast<double>(kSamples));

TEST(Uniform, HasTheMeanTheVarianceAndTheRangeOfItsDistribution) {
  const auto values = draws(uniform, 1, kStream);
  double sum_of_squares = 0;
  for (const double value : values) {
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum_of_squares += (value - 0.5) * (value - 0.5);
  }
  EXPECT_NEAR(mean(values), 0.5, kFiveSigma / std::sqrt(12.0));
  EXPECT_NEAR(sum_of_squares / kSamples, 1.0 / 12.0, 1e-3);
}

TEST(Uniform, FillsItsRangeEvenly) {
  constexpr int kBins = 50;
  std::vector<double> counts(kBins, 0.0);
  for (const double value : draws(uniform, 7, kStream)) {
    ++counts[static_cast<std::size_t>(value * kBins)];
  }
  const double expected = static_cast<double>(kSamples) / kBins;
  double chi_squared = 0;
  for (const double count : counts)
    chi_squared += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_squared, 102.0);  // 49 degrees of freedom, p = 1e-5
}

TEST(Gaussian, HasTheMomentsAndTheTailsOfTheNormalDistribution) {
  const auto values = draws(gaussian, 1, kStream);
  double second = 0, third = 0, fourth = 0;
  int beyond_two = 0;
  for (const double value : values) {
    ASSERT_TRUE(std::isfinite(value));
    second += value * value;
    third += value * value * value;
    fourth += value * value * value * value;
    beyond_two += std::abs(value) > 2.0 ? 1 : 0;
  }
  EXPECT_NEAR(mean(values), 0.0, kFiveSigma);
  EXPECT_NEAR(second / kSamples, 1.0, std::sqrt(2.0) * kFiveSigma);
  EXPECT_NEAR(third / kSamples, 0.0, std::sqrt(15.0) * kFiveSigma);
  EXPECT_NEAR(fourth / kSamples, 3.0, std::sqrt(96.0) * kFiveSigma);
  EXPECT_NEAR(beyond_two / static_cast<double>(kSamples), 0.0455, 0.003);
}

TEST(Independence, OfNeighbouringIndices) {
  for (const Draw draw : {uniform, gaussian}) {
    const auto values = draws(draw, 3, kStream);
    for (const std::size_t lag : {1U, 2U, 3U, 64U}) {
      EXPECT_NEAR(correlation(values, values, lag), 0.0, kFiveSigma) << "lag " << lag;
    }
  }
}

TEST(Independence, OfStreamsSeedsAndDistributions) {
  const auto values = draws(uniform, 3, kStream);
  EXPECT_NEAR(correlation(values, draws(uniform, 3, stream("tesu")), 0), 0.0, kFiveSigma);
  EXPECT_NEAR(correlation(values, draws(uniform, 3, kStream + 1), 0), 0.0, kFiveSigma);
  EXPECT_NEAR(correlation(values, draws(uniform, 4, kStream), 0), 0.0, kFiveSigma);
  EXPECT_NEAR(correlation(values, draws(gaussian, 3, kStream), 0), 0.0, kFiveSigma);
}

TEST(Bits, EveryInputBitChangesAboutHalfOfTheOutput) {
  const std::uint64_t before = bits(11, kStream, 42);
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t flip = std::uint64_t{1} << bit;
    for (const std::uint64_t after : {bits(11 ^ flip, kStream, 42), bits(11, kStream ^ flip, 42),
                                      bits(11, kStream, 42 ^ flip)}) {
      const int changed = __builtin_popcountll(before ^ after);
      EXPECT_GT(changed, 10) << "bit " << bit;
      EXPECT_LT(changed, 54) << "bit " << bit;
    }
  }
}

TEST(Bits, AreAPureFunctionOfTheirArguments) {
  std::vector<std::uint64_t> forwards, backwards;
  for (std::uint64_t i = 0; i < 100; ++i) forwards.push_back(bits(5, kStream, i));
  for (std::uint64_t i = 100; i-- > 0;) backwards.insert(backwards.begin(), bits(5, kStream, i));
  EXPECT_EQ(forwards, backwards);
  EXPECT_EQ(gaussian(5, kStream, 3), gaussian(5, kStream, 3));
}

TEST(Bits, DoNotRepeatOverSmallArguments) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t from = 0; from < 20; ++from) {
      for (std::uint64_t index = 0; index < 20; ++index) seen.insert(bits(seed, from, index));
    }
  }
  EXPECT_EQ(seen.size(), 8000U);
}

// Recorded trials name only their seed: these values are part of the project's file formats.
TEST(Bits, AreTheSameOnEveryPlatform) {
  static_assert(stream("") == 0xcbf29ce484222325ULL, "FNV-1a offset basis");
  static_assert(stream("a") == 0xaf63dc4c8601ec8cULL, "FNV-1a published test vector");
  // The mixer is SplitMix64, whose first output for state 0 is published; these arguments cancel
  // the outer rounds to state 0.
  constexpr std::uint64_t kSplitMixOfZero = 0xe220a8397b1dcdafULL;
  EXPECT_EQ(bits(0, kSplitMixOfZero, kSplitMixOfZero), kSplitMixOfZero);
}

}  // namespace
}  // namespace scarab::random
