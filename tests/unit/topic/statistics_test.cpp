#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "tools/topic/arrival_rate.hpp"
#include "tools/topic/delay_meter.hpp"
#include "tools/topic/moments.hpp"
#include "tools/topic/rate_meter.hpp"

namespace scarab::topic {
namespace {

using testing::HasSubstr;

TEST(Moments, AreThoseOfAllNumbersHoweverTheyCame) {
  const std::vector<double> values{3.0, -1.0, 4.0, 1.0, -5.0, 9.0, 2.5};
  Moments all;
  Moments first;
  Moments second;
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    all.add(values[i]);
    (i < 3 ? first : second).add(values[i]);
    sum += values[i];
  }
  first.add(second);
  first.add(Moments());
  const double mean = sum / 7.0;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  for (const Moments& moments : {all, first}) {
    EXPECT_EQ(moments.count(), 7U);
    EXPECT_NEAR(moments.mean(), mean, 1e-12);
    EXPECT_NEAR(moments.standard_deviation(), std::sqrt(squares / 7.0), 1e-12);
    EXPECT_EQ(moments.min(), -5.0);
    EXPECT_EQ(moments.max(), 9.0);
  }
}

TEST(Moments, OfNothingAreNoNumbers) {
  const Moments none;
  EXPECT_EQ(none.count(), 0U);
  EXPECT_TRUE(std::isnan(none.mean()));
  EXPECT_TRUE(std::isnan(none.min()));
  EXPECT_TRUE(std::isnan(none.standard_deviation()));
}

TEST(ArrivalRate, IsReachedBySamplesOfJustThatRate) {
  ArrivalRate rate(10.0);
  for (std::int64_t i = 0; i <= 9; ++i) {
    rate.add(i * 100'000'000);
    EXPECT_FALSE(rate.reached()) << i;
  }
  rate.add(1'000'000'000);
  EXPECT_TRUE(rate.reached());
  EXPECT_NEAR(rate.rate_hz(), 10.0, 1e-9);
}

TEST(ArrivalRate, ForgetsHowItWas) {
  ArrivalRate rate(10.0);
  for (std::int64_t i = 0; i <= 20; ++i) rate.add(i * 90'000'000);
  EXPECT_TRUE(rate.reached());
  rate.add(2'300'000'000);
  EXPECT_FALSE(rate.reached());
}

TEST(ArrivalRate, OfSlowTopicsLooksAtThreeSamples) {
  ArrivalRate rate(0.5);
  rate.add(0);
  rate.add(2'000'000'000);
  EXPECT_FALSE(rate.reached());
  rate.add(4'000'000'000);
  EXPECT_TRUE(rate.reached());
}

bus::RawSample arriving_at(double seconds, double delay_s = 0.0) {
  bus::RawSample sample;
  sample.reception_ns = std::llround(seconds * 1e9);
  sample.source_ns = std::llround((seconds - delay_s) * 1e9);
  return sample;
}

TEST(RateMeter, LooksBackAWindow) {
  RateMeter meter;
  for (int i = 0; i < 10; ++i) meter.add(arriving_at(0.1 * i));
  meter.end_second(1.0, 2);
  EXPECT_THAT(meter.row(),
              testing::ElementsAre("10.0", "100.000", "100.000", "100.000", "0.000", "10"));
  for (int second = 1; second < 4; ++second) {
    for (int i = 0; i < 5; ++i) meter.add(arriving_at(second + 0.2 * i));
    meter.end_second(1.0, 2);
  }
  // Of the last two seconds: the first one, and the change to 5 Hz, are forgotten.
  EXPECT_THAT(meter.json(), HasSubstr("{\"rate_hz\": 5, "));
  EXPECT_THAT(meter.json(), HasSubstr("\"samples\": 10, \"window_s\": 2}"));
}

TEST(RateMeter, OfSilenceIsZero) {
  RateMeter meter;
  meter.end_second(1.0, 10);
  EXPECT_THAT(meter.row(), testing::ElementsAre("0.0", "-", "-", "-", "-", "0"));
  EXPECT_THAT(meter.json(), HasSubstr("\"interval_mean_s\": null"));
}

TEST(DelayMeter, TellsPercentiles) {
  DelayMeter meter("");
  for (int i = 1; i <= 100; ++i) meter.add(arriving_at(1000.0 + i, 0.001 * i));
  meter.end_second(1.0, 10);
  EXPECT_THAT(meter.row(), testing::ElementsAre("50.500", "1.000", "50.000", "95.000", "99.000",
                                                "100.000", "100"));
}

}  // namespace
}  // namespace scarab::topic
