#include "services/plant/core/command_delay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace scarab::plant {
namespace {

constexpr std::int64_t kStepNs = 2'000'000;
constexpr double kStepS = 0.002;
constexpr std::int64_t kNone = -1;  // what holds before the first command

/// A command that tells its number.
robot::JointVector command(std::int64_t k) {
  robot::JointVector out;
  out.fill(static_cast<double>(k));
  return out;
}

/// The number of the command in effect at each step; one is sent every `period` steps.
std::vector<std::int64_t> in_effect(std::int64_t latency, std::int64_t jitter, std::int64_t period,
                                    std::int64_t commands, std::uint64_t seed = 1) {
  CommandDelay delay({kStepS * static_cast<double>(latency), kStepS * static_cast<double>(jitter)},
                     seed, kStepNs, command(kNone));
  std::vector<std::int64_t> out;
  for (std::int64_t step = 0; step < commands * period; ++step) {
    if (step % period == 0) {
      delay.send(static_cast<std::uint64_t>(step / period), step, command(step / period));
    }
    out.push_back(static_cast<std::int64_t>(delay.arrived_at(step)[0]));
  }
  return out;
}

/// The step at which each command took effect after it was sent; kNone for one that never did.
std::vector<std::int64_t> delays(const std::vector<std::int64_t>& effect, std::int64_t period) {
  std::vector<std::int64_t> out(effect.size() / static_cast<std::size_t>(period), kNone);
  for (std::size_t step = 0; step < effect.size(); ++step) {
    if (effect[step] == kNone) continue;
    auto& delay = out[static_cast<std::size_t>(effect[step])];
    if (delay == kNone) delay = static_cast<std::int64_t>(step) - effect[step] * period;
  }
  return out;
}

TEST(CommandDelay, WithoutDelayACommandHoldsFromTheStepItWasSentAt) {
  const auto effect = in_effect(0, 0, 5, 4);
  for (std::size_t step = 0; step < effect.size(); ++step) {
    EXPECT_EQ(effect[step], static_cast<std::int64_t>(step / 5));
  }
}

TEST(CommandDelay, LatencyIsExactToAStep) {
  for (const std::int64_t latency : {1, 3, 7, 23}) {  // 23: four commands under way at once
    const auto effect = in_effect(latency, 0, 5, 12);
    for (std::int64_t step = 0; step < 60; ++step) {
      EXPECT_EQ(effect[static_cast<std::size_t>(step)],
                step < latency ? kNone : (step - latency) / 5);
    }
  }
}

TEST(CommandDelay, JitterIsUniformOverItsSteps) {
  const std::int64_t commands = 6000;
  std::vector<int> count(11, 0);
  for (const std::int64_t delay : delays(in_effect(3, 10, 20, commands), 20)) {
    ASSERT_GE(delay, 3);
    ASSERT_LE(delay, 13);
    ++count[static_cast<std::size_t>(delay - 3)];
  }
  for (const int times : count) EXPECT_NEAR(times, 6000 / 11.0, 4 * std::sqrt(6000 / 11.0));
}

TEST(CommandDelay, JitterIsAFunctionOfSeedAndCommand) {
  EXPECT_EQ(in_effect(0, 10, 20, 50, 7), in_effect(0, 10, 20, 50, 7));
  EXPECT_NE(in_effect(0, 10, 20, 50, 7), in_effect(0, 10, 20, 50, 8));
  // The same draws, whatever was sent before: command 30 alone is as late as command 30 of many.
  const auto all = delays(in_effect(0, 10, 20, 50), 20);
  CommandDelay alone({0, 10 * kStepS}, 1, kStepNs, command(kNone));
  alone.send(30, 600, command(30));
  std::int64_t step = 600;
  while (alone.arrived_at(step)[0] < 0 && step < 620) ++step;
  EXPECT_EQ(step - 600, all[30]);
}

TEST(CommandDelay, AnOvertakenCommandNeverTakesEffect) {
  const auto effect = in_effect(2, 30, 5, 400);
  for (std::size_t step = 1; step < effect.size(); ++step) {
    EXPECT_GE(effect[step], effect[step - 1]) << "back to an older command at step " << step;
  }
  std::size_t overtaken = 0;
  for (const std::int64_t delay : delays(effect, 5)) overtaken += delay == kNone ? 1 : 0;
  EXPECT_GT(overtaken, 50U);
  EXPECT_LT(overtaken, 350U);
}

/// Each command's arrival follows from its own delay, so what should be in effect is known.
TEST(CommandDelay, TheNewestThatHasArrivedIsInEffect) {
  std::vector<std::int64_t> arrival;
  for (std::int64_t k = 0; k < 100; ++k) {
    CommandDelay alone({2 * kStepS, 30 * kStepS}, 1, kStepNs, command(kNone));
    alone.send(static_cast<std::uint64_t>(k), 5 * k, command(k));
    std::int64_t step = 5 * k;
    while (alone.arrived_at(step)[0] < 0 && step < 5 * k + 40) ++step;
    arrival.push_back(step);
  }
  const auto effect = in_effect(2, 30, 5, 100);
  for (std::int64_t step = 0; step < 500; ++step) {
    std::int64_t newest = kNone;
    for (std::int64_t k = 0; k < 100; ++k) {
      if (5 * k <= step && arrival[static_cast<std::size_t>(k)] <= step) newest = k;
    }
    EXPECT_EQ(effect[static_cast<std::size_t>(step)], newest) << step;
  }
}

TEST(CommandDelay, RefusesTimesBetweenSteps) {
  EXPECT_THROW(CommandDelay({0.003, 0}, 1, kStepNs, {}), std::invalid_argument);
  EXPECT_THROW(CommandDelay({0, 0.001}, 1, kStepNs, {}), std::invalid_argument);
  EXPECT_THROW(CommandDelay({-0.002, 0}, 1, kStepNs, {}), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::plant
