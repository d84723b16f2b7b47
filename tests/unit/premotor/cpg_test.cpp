#include "services/premotor/core/cpg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "services/premotor/core/network.hpp"
#include "tests/unit/premotor/f2_config.hpp"
#include "tests/unit/premotor/rhythm.hpp"

namespace scarab::premotor {
namespace {

constexpr double kTwoPi = 6.283185307179586476925;
using Orbit = std::vector<std::array<double, 2>>;

/// The oscillator alone, after its transient.
Orbit orbit(double w11, double w12, std::size_t ticks) {
  constexpr int kTransientTicks = 2000;
  NetworkDescription description;
  for (const char* name : {"I1", "I2", "I3", "I4"}) {
    description.add_input(name);
  }
  const CpgNeurons cpg = add_cpg(description, {w11, w12, {}});
  const Network network(std::move(description));
  Eigen::VectorXd output = Eigen::VectorXd::Zero(6);
  output[static_cast<Eigen::Index>(cpg.c1)] = 0.1;
  output[static_cast<Eigen::Index>(cpg.c2)] = 0.1;
  Orbit points;
  for (int i = 0; i < kTransientTicks; ++i) {
    output = network.step(output, {});
  }
  for (std::size_t i = 0; i < ticks; ++i) {
    output = network.step(output, {});
    points.push_back({output[4], output[5]});
  }
  return points;
}

double period_ticks(const Orbit& points) { return kTwoPi / std::abs(turn_per_tick_rad(points)); }

struct Measured {
  double w12;
  double period_ticks;
  double tolerance_ticks;  ///< half of the last digit of the table
};

void PrintTo(const Measured& measured, std::ostream* out) { *out << "w12 " << measured.w12; }

class CpgPeriod : public testing::TestWithParam<Measured> {};

// Periods measured before by counting upward zero crossings of C1; here by the angle turned.
TEST_P(CpgPeriod, FollowsTheWeights) {
  const Measured& row = GetParam();
  EXPECT_NEAR(period_ticks(orbit(1.4, row.w12, 20000)), row.period_ticks, row.tolerance_ticks);
}

INSTANTIATE_TEST_SUITE_P(Table, CpgPeriod,
                         testing::Values(Measured{0.18, 285, 1.5}, Measured{0.22, 75, 0.6},
                                         Measured{0.26, 51, 0.6}, Measured{0.30, 40, 0.6},
                                         Measured{0.35, 31.6, 0.06}, Measured{0.40, 26.6, 0.06},
                                         Measured{0.50, 20.4, 0.06}, Measured{0.60, 16.8, 0.06},
                                         Measured{0.70, 14.4, 0.06}));

class CpgOrbit : public testing::TestWithParam<double> {};

TEST_P(CpgOrbit, StaysInAnAnnulusAndAlwaysAdvances) {
  const Orbit points = orbit(1.4, GetParam(), 20000);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [c1, c2] = points[i];
    ASSERT_LT(std::max(std::abs(c1), std::abs(c2)), 1.0);
    ASSERT_GT(std::hypot(c1, c2), 0.5) << "does not fall back to the unstable origin";
    const double turn = wrap(std::atan2(c2, c1) - std::atan2(points[i - 1][1], points[i - 1][0]));
    ASSERT_LT(turn, 0) << "C1 leads: always the same sense";
  }
}

// Quasi-periodic (paper, Fig. 2(b)): no small number of steps brings the orbit back to where it
// was, and every part of the closed curve is visited.
TEST_P(CpgOrbit, IsQuasiPeriodic) {
  const Orbit points = orbit(1.4, GetParam(), 20000);
  for (std::size_t period = 1; period <= 100; ++period) {
    double worst = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
      worst = std::max(worst, std::hypot(points[i + period][0] - points[i][0],
                                         points[i + period][1] - points[i][1]));
    }
    EXPECT_GT(worst, 1e-4) << "repeats after " << period << " steps";
  }
  std::vector<double> angles;
  for (const auto& [c1, c2] : points) {
    angles.push_back(std::atan2(c2, c1));
  }
  std::sort(angles.begin(), angles.end());
  for (std::size_t i = 1; i < angles.size(); ++i) {
    ASSERT_LT(angles[i] - angles[i - 1], 0.02) << "a gap in the curve at " << angles[i] << " rad";
  }
}

TEST_P(CpgOrbit, HasTheSameAmplitudeInBothNeurons) {
  const Orbit points = orbit(1.4, GetParam(), 20000);
  std::array<double, 2> peak{};
  for (const auto& point : points) {
    peak = {std::max(peak[0], point[0]), std::max(peak[1], point[1])};
  }
  EXPECT_NEAR(peak[0], peak[1], 1e-3);
  EXPECT_GT(peak[0], 0.86);
  EXPECT_LT(peak[0], 0.95);
}

INSTANTIATE_TEST_SUITE_P(Weights, CpgOrbit, testing::Values(0.35, 0.60, 0.70));

TEST(Cpg, DiesOutBelowTheBifurcation) {
  const Orbit points = orbit(0.9, 0.3, 10);
  EXPECT_LT(std::hypot(points.back()[0], points.back()[1]), 1e-6);
}

}  // namespace
}  // namespace scarab::premotor
