#include "tools/status/rates.hpp"

#include <gtest/gtest.h>

namespace scarab::status {
namespace {

using std::chrono::milliseconds;
using Reports = std::map<bus::Peer, runtime::ServiceReport>;

constexpr std::uint32_t kTrial = 3;
const bus::Peer kPlant{"plant", 0};

/// Reports of one service, a quarter of a second apart.
struct Rates : testing::Test {
  RateMeter meter;
  RateMeter::TimePoint now{};

  void report(std::uint32_t tick, std::uint32_t trial = kTrial) {
    now += milliseconds(250);
    runtime::ServiceReport said;
    said.header = {trial, tick, static_cast<std::int64_t>(tick) * 100'000'000,
                   now.time_since_epoch().count()};
    meter.observe(Reports{{kPlant, said}}, now);
  }
  [[nodiscard]] Rate rate() const { return meter.of(kPlant, now); }
};

TEST_F(Rates, NobodyHasNone) {
  EXPECT_EQ(rate().ticks_per_s, 0);
  report(7);
  EXPECT_EQ(rate().ticks_per_s, 0);  // a single report does not tell
}

TEST_F(Rates, TicksAndSimulatedTimeOverTheTimeOfTheReports) {
  for (std::uint32_t i = 0; i < 5; ++i) report(20 * i);
  EXPECT_DOUBLE_EQ(rate().ticks_per_s, 80);
  EXPECT_DOUBLE_EQ(rate().real_time_factor, 8);
}

TEST_F(Rates, ChangeOfSpeedShowsWithinTheWindow) {
  for (std::uint32_t i = 0; i < 40; ++i) report(20 * i);
  for (std::uint32_t i = 0; i < 22; ++i) report(800 + i);  // longer than the window
  EXPECT_DOUBLE_EQ(rate().ticks_per_s, 4);
}

TEST_F(Rates, NewTrialCountsFromItsBeginning) {
  for (std::uint32_t i = 0; i < 5; ++i) report(20 * i);
  report(1, kTrial + 1);
  EXPECT_EQ(rate().ticks_per_s, 0);
  report(3, kTrial + 1);
  EXPECT_DOUBLE_EQ(rate().ticks_per_s, 8);
}

TEST_F(Rates, StandstillIsZeroThoughItWasFast) {
  for (std::uint32_t i = 0; i < 5; ++i) report(20 * i);
  for (int i = 0; i < 5; ++i) report(80);
  EXPECT_EQ(rate().ticks_per_s, 0);
}

}  // namespace
}  // namespace scarab::status
