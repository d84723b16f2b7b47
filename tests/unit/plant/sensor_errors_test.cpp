#include "services/plant/core/sensor_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace scarab::plant {
namespace {

constexpr int kSamples = 40000;

SensorErrors noisy(double noise) {
  SensorErrors errors;
  errors.noise = noise;
  return errors;
}

SensorErrors biased(double bias) {
  SensorErrors errors;
  errors.bias = bias;
  return errors;
}

struct Statistics {
  double mean = 0;
  double deviation = 0;
};

Statistics statistics(const std::function<double(std::uint64_t)>& value, int count = kSamples) {
  double sum = 0, square = 0;
  for (int i = 0; i < count; ++i) {
    const double x = value(static_cast<std::uint64_t>(i));
    sum += x;
    square += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(square / count - mean * mean)};
}

/// Correlation of two series of unit noise.
double correlation(const std::function<double(std::uint64_t)>& a,
                   const std::function<double(std::uint64_t)>& b) {
  double sum = 0;
  for (std::uint64_t i = 0; i < kSamples; ++i) sum += a(i) * b(i);
  return sum / kSamples;
}

const double kFourSigma = 4 / std::sqrt(kSamples);  // of a mean of unit numbers

TEST(SensorErrors, WithoutAnyTheReadingIsTheTruthToTheBit) {
  const SensorErrorModel ideal({}, "joint_position", 1);
  for (const double truth : {0.0, -0.0, 1.0 / 3, -1e-300, 123.456}) {
    EXPECT_EQ(ideal.reading(truth, 3, 7), truth);
    EXPECT_EQ(std::signbit(ideal.reading(truth, 3, 7)), std::signbit(truth));
    EXPECT_FALSE(ideal.lost(3, 7));
  }
}

TEST(SensorErrors, NoiseHasMeanZeroAndItsDeviation) {
  const SensorErrorModel model(noisy(0.02), "joint_position", 5);
  const Statistics seen = statistics([&](auto n) { return model.reading(1.5, 2, n); });
  EXPECT_NEAR(seen.mean, 1.5, 0.02 * kFourSigma);
  EXPECT_NEAR(seen.deviation, 0.02, 0.02 * kFourSigma / std::sqrt(2.0));
}

TEST(SensorErrors, NoiseIsNormal) {
  const SensorErrorModel model(noisy(1), "joint_position", 5);
  int within_one = 0, within_two = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double size = std::abs(model.reading(0, 0, static_cast<std::uint64_t>(i)));
    within_one += size < 1 ? 1 : 0;
    within_two += size < 2 ? 1 : 0;
  }
  EXPECT_NEAR(within_one / double{kSamples}, 0.6827, 0.01);
  EXPECT_NEAR(within_two / double{kSamples}, 0.9545, 0.005);
}

TEST(SensorErrors, NoiseOfElementsSensorsTrialsAndSamplesIsIndependent) {
  const SensorErrorModel model(noisy(1), "joint_position", 5);
  const SensorErrorModel other_sensor(noisy(1), "joint_velocity", 5);
  const SensorErrorModel other_trial(noisy(1), "joint_position", 6);
  const auto series = [&](auto n) { return model.reading(0, 0, n); };
  EXPECT_NEAR(correlation(series, series), 1, 2 * kFourSigma);
  EXPECT_NEAR(correlation(series, [&](auto n) { return model.reading(0, 1, n); }), 0, kFourSigma);
  EXPECT_NEAR(correlation(series, [&](auto n) { return model.reading(0, 0, n + 1); }), 0,
              kFourSigma);
  EXPECT_NEAR(correlation(series, [&](auto n) { return other_sensor.reading(0, 0, n); }), 0,
              kFourSigma);
  EXPECT_NEAR(correlation(series, [&](auto n) { return other_trial.reading(0, 0, n); }), 0,
              kFourSigma);
}

TEST(SensorErrors, BiasIsConstantWithinATrial) {
  const SensorErrorModel model(biased(0.1), "inclination", 5);
  const double offset = model.reading(0, 1, 0);
  EXPECT_NE(offset, 0);
  for (std::uint64_t n = 1; n < 1000; ++n) {
    EXPECT_EQ(model.reading(0, 1, n), offset);
    EXPECT_DOUBLE_EQ(model.reading(2, 1, n), 2 + offset);
  }
}

TEST(SensorErrors, BiasDiffersBetweenTrialsAndElementsByItsDeviation) {
  const Statistics trials = statistics([](auto seed) {
    return SensorErrorModel(biased(0.1), "inclination", seed).reading(0, 0, 3);
  });
  EXPECT_NEAR(trials.mean, 0, 0.1 * kFourSigma);
  EXPECT_NEAR(trials.deviation, 0.1, 0.1 * kFourSigma / std::sqrt(2.0));
  const SensorErrorModel model(biased(0.1), "inclination", 5);
  const Statistics elements = statistics([&](auto i) { return model.reading(0, i, 3); });
  EXPECT_NEAR(elements.mean, 0, 0.1 * kFourSigma);
  EXPECT_NEAR(elements.deviation, 0.1, 0.1 * kFourSigma / std::sqrt(2.0));
}

TEST(SensorErrors, BiasAndNoiseAreIndependent) {
  SensorErrors both = noisy(1);
  both.bias = 1;
  const Statistics seen = statistics(
      [&](auto seed) { return SensorErrorModel(both, "inclination", seed).reading(0, 0, 0); });
  EXPECT_NEAR(seen.deviation, std::sqrt(2.0), 1.5 * kFourSigma);
}

TEST(SensorErrors, QuantisedReadingsLieOnTheGridNearestToTheTruth) {
  SensorErrors errors;
  errors.quantum = 0.25;
  const SensorErrorModel model(errors, "joint_position", 5);
  for (double truth = -3; truth < 3; truth += 0.013) {
    const double reading = model.reading(truth, 0, 0);
    EXPECT_EQ(reading / 0.25, std::round(reading / 0.25)) << truth;
    EXPECT_LE(std::abs(reading - truth), 0.125 + 1e-12) << truth;
  }
  EXPECT_FALSE(std::signbit(model.reading(-0.1, 0, 0))) << "no negative zero";
}

/// The converter sees the noise: so the mean of many readings is finer than a step.
TEST(SensorErrors, NoiseComesBeforeQuantisation) {
  SensorErrors errors = noisy(0.25);
  errors.quantum = 0.25;
  const SensorErrorModel model(errors, "joint_position", 5);
  const Statistics seen = statistics([&](auto n) { return model.reading(0.1, 0, n); });
  EXPECT_NEAR(seen.mean, 0.1, 0.3 * kFourSigma);
  std::set<double> steps;
  for (std::uint64_t n = 0; n < 1000; ++n) steps.insert(model.reading(0.1, 0, n) / 0.25);
  for (const double step : steps) EXPECT_EQ(step, std::round(step));
  EXPECT_GE(steps.size(), 4U);
}

TEST(SensorErrors, LossesComeAtTheirRateAndIndependently) {
  SensorErrors errors;
  errors.dropout = 0.2;
  const SensorErrorModel model(errors, "joint_position", 5);
  const auto lost = [&](auto n) { return model.lost(0, n) ? 1.0 : 0.0; };
  const double deviation = std::sqrt(0.2 * 0.8);
  EXPECT_NEAR(statistics(lost).mean, 0.2, deviation * kFourSigma);
  // Twice in a row, and both of two elements: 0.2 squared.
  EXPECT_NEAR(correlation(lost, [&](auto n) { return lost(n + 1); }), 0.04, kFourSigma * 0.2);
  EXPECT_NEAR(correlation(lost, [&](auto n) { return model.lost(1, n) ? 1.0 : 0.0; }), 0.04,
              kFourSigma * 0.2);
  for (std::size_t element = 0; element < 200; ++element) EXPECT_FALSE(model.lost(element, 0));
}

TEST(SensorErrors, DependOnNothingThatWasAskedBefore) {
  SensorErrors errors{0.1, 0.1, 1e-3, 0, 0.3};
  const SensorErrorModel forward(errors, "foot_force", 9), backward(errors, "foot_force", 9);
  std::vector<double> first, second;
  for (std::uint64_t n = 0; n < 500; ++n) first.push_back(forward.reading(1, n % 6, n));
  for (std::uint64_t n = 500; n-- > 0;) {
    static_cast<void>(backward.lost(n % 5, n));
    static_cast<void>(backward.reading(4, 5, 1000 + n));
    second.insert(second.begin(), backward.reading(1, n % 6, n));
  }
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace scarab::plant
