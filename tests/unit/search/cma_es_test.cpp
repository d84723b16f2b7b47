#include "tools/search/cma_es.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace scarab::search {
namespace {

using Point = CmaEs::Point;
using Function = std::function<double(const Point&)>;

constexpr std::size_t kDimension = 8;

/// All functions have their minimum, 0, at 0.3 in every coordinate.
double sphere(const Point& point) {
  double sum = 0;
  for (const double x : point) sum += (x - 0.3) * (x - 0.3);
  return sum;
}

double rosenbrock(const Point& point) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < point.size(); ++i) {
    const double x = point[i] + 0.7;
    const double y = point[i + 1] + 0.7;
    sum += 100 * std::pow(y - x * x, 2) + std::pow(1 - x, 2);
  }
  return sum;
}

/// Axes from 1 to 1000, turned against the coordinates.
double rotated_ellipsoid(const Point& point) {
  const auto n = static_cast<Eigen::Index>(point.size());
  Eigen::MatrixXd any(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j)
      any(i, j) = std::sin(1.0 + 3.7 * double(i) + 1.3 * double(j * j));
  }
  const Eigen::MatrixXd turn = Eigen::HouseholderQR<Eigen::MatrixXd>(any).householderQ();
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(point.data(), n).array() - 0.3;
  x = turn * x;
  double sum = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    sum += std::pow(1000.0, 2.0 * double(i) / double(n - 1)) * x[i] * x[i];
  }
  return sum;
}

CmaEs begin(std::uint32_t seed = 1) { return {Point(kDimension, 0.8), 0.2, 12, seed}; }

void step(CmaEs& optimiser, const Function& function) {
  std::vector<double> costs;
  for (const Point& point : optimiser.ask()) costs.push_back(function(point));
  optimiser.tell(costs);
}

double minimum_after(int generations, const Function& function) {
  CmaEs optimiser = begin();
  for (int i = 0; i < generations; ++i) step(optimiser, function);
  return function(optimiser.mean());
}

TEST(CmaEs, FindsTheMinimumOfTheSphere) { EXPECT_LT(minimum_after(150, sphere), 1e-8); }

TEST(CmaEs, FollowsTheValleyOfRosenbrock) { EXPECT_LT(minimum_after(700, rosenbrock), 1e-6); }

TEST(CmaEs, LearnsTheAxesOfARotatedEllipsoid) {
  EXPECT_LT(minimum_after(450, rotated_ellipsoid), 1e-6);
}

TEST(CmaEs, RepeatsItselfExactlyFromItsSeed) {
  CmaEs a = begin();
  CmaEs b = begin();
  CmaEs other = begin(2);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(a.ask(), b.ask()) << "generation " << i;
    ASSERT_NE(a.ask(), other.ask());
    for (CmaEs* optimiser : {&a, &b, &other}) step(*optimiser, rosenbrock);
  }
}

TEST(CmaEs, DoesNotDependOnAnotherThatRunsInBetween) {
  CmaEs alone = begin();
  for (int i = 0; i < 20; ++i) step(alone, sphere);
  CmaEs one = begin();
  CmaEs two = begin(2);
  for (int i = 0; i < 20; ++i) {
    step(two, rosenbrock);
    step(one, sphere);
  }
  EXPECT_EQ(one.ask(), alone.ask());
}

TEST(CmaEs, GoesByTheOrderOfTheCostsAlone) {
  CmaEs plain = begin();
  CmaEs distorted = begin();
  for (int i = 0; i < 20; ++i) {
    step(plain, sphere);
    step(distorted, [](const Point& point) { return std::atan(sphere(point)) - 5; });
  }
  EXPECT_EQ(plain.ask(), distorted.ask());
}

TEST(CmaEs, AsksForTheSameUntilItIsTold) {
  CmaEs optimiser = begin();
  const auto first = optimiser.ask();
  EXPECT_EQ(optimiser.ask(), first);
  step(optimiser, sphere);
  EXPECT_NE(optimiser.ask(), first);
}

TEST(CmaEs, BeginsAroundTheStartWithTheSigmaGiven) {
  const CmaEs optimiser(Point(kDimension, 0.8), 0.2, 4000, 1);
  EXPECT_EQ(optimiser.mean(), Point(kDimension, 0.8));
  EXPECT_NEAR(optimiser.spread(), 0.2, 0.004);
}

/// mean() is recombined here, because pagmo keeps its own to itself: both must be the same.
TEST(CmaEs, DrawsAroundItsMean) {
  CmaEs optimiser(Point(kDimension, 0.8), 0.2, 4000, 1);
  for (int i = 0; i < 3; ++i) step(optimiser, sphere);
  Point average(kDimension, 0.0);
  for (const Point& point : optimiser.ask()) {
    for (std::size_t k = 0; k < kDimension; ++k) average[k] += point[k] / 4000;
  }
  const double four_standard_errors = 4 * optimiser.spread() / std::sqrt(4000.0);
  for (std::size_t k = 0; k < kDimension; ++k) {
    EXPECT_NEAR(average[k], optimiser.mean()[k], four_standard_errors);
  }
}

TEST(CmaEs, RefusesWhatItCannotUse) {
  EXPECT_THROW(CmaEs(Point(3, 0.5), 0.2, 4, 1), std::invalid_argument);
  CmaEs optimiser = begin();
  EXPECT_THROW(optimiser.tell({1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(optimiser.tell(std::vector<double>(12, NAN)), std::invalid_argument);
}

}  // namespace
}  // namespace scarab::search
