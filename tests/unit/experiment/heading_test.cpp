#include "services/experiment/core/heading.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scarab::experiment {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNear = 1e-12;

using Quaternion = std::array<double, 4>;

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Quaternion about(std::size_t axis, double angle_rad) {
  Quaternion turn{std::cos(angle_rad / 2), 0, 0, 0};
  turn.at(axis + 1) = std::sin(angle_rad / 2);
  return turn;
}

TEST(Heading, IsThatOfTheXAxisHoweverTheBodyLeans) {
  for (const double yaw : {-3.0, -1.0, 0.0, 0.2, 3.1}) {
    for (const double pitch : {-1.4, 0.0, 1.2}) {
      for (const double roll : {-2.0, 0.0, 0.7}) {
        const auto leaning = product(about(2, yaw), product(about(1, pitch), about(0, roll)));
        EXPECT_NEAR(heading_rad(leaning), yaw, kNear) << pitch << " " << roll;
      }
    }
  }
}

TEST(Heading, IsTheSameForBothSignsOfAQuaternion) {
  const auto turn = about(2, 2.5);
  EXPECT_NEAR(heading_rad({-turn[0], -turn[1], -turn[2], -turn[3]}), 2.5, kNear);
}

TEST(Turn, IsNothingBeforeTheSecondSample) {
  Turn turn;
  EXPECT_EQ(turn.turned_rad(), 0);
  turn.see(2.9);
  EXPECT_EQ(turn.turned_rad(), 0);
  EXPECT_EQ(turn.most_rad(), 0);
}

TEST(Turn, GoesOnThroughPi) {
  Turn turn;
  turn.see(3.0);
  turn.see(-3.0);  // 0.28 rad to the left
  EXPECT_NEAR(turn.turned_rad(), 2 * kPi - 6.0, kNear);
  turn.see(3.0);
  EXPECT_NEAR(turn.turned_rad(), 0, kNear);
  turn.see(2.0);
  EXPECT_NEAR(turn.turned_rad(), -1.0, kNear);
}

TEST(Turn, CountsWholeTurnsEitherWay) {
  for (const double step : {0.3, -0.3, 2.9, -2.9}) {
    Turn turn;
    double sum = 0;
    turn.see(1.0);
    for (int i = 0; i < 100; ++i) {
      sum += step;
      turn.see(std::remainder(1.0 + sum, 2 * kPi));
    }
    EXPECT_NEAR(turn.turned_rad(), sum, 1e-9) << step;
    EXPECT_NEAR(turn.most_rad(), std::abs(sum), 1e-9) << step;
  }
}

TEST(Turn, RemembersTheMostOfBothSides) {
  Turn turn;
  for (const double heading : {0.5, 0.6, -0.4, 0.5}) turn.see(heading);
  EXPECT_NEAR(turn.turned_rad(), 0, kNear);
  EXPECT_NEAR(turn.most_rad(), 0.9, kNear);
}

}  // namespace
}  // namespace scarab::experiment
