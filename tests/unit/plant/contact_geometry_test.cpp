#include "services/plant/core/contact_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/random/random.hpp"

namespace scarab::plant {
namespace {

using Eigen::Vector3d;

/// Reproducible points in a cube.
class Points {
 public:
  explicit Points(std::uint64_t seed) : seed_(seed) {}
  double number(double bound) { return bound * (2 * random::uniform(seed_, 0, index_++) - 1); }
  Vector3d point(double bound) {
    const double x = number(bound), y = number(bound);
    return {x, y, number(bound)};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t index_ = 0;
};

constexpr int kTrials = 300;
constexpr int kSamples = 2000;

/// Depth of a capsule in a shape, by trying every point of its segment.
template <class Shape>
double brute_depth(const Shape& shape, const Capsule& capsule) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSamples; ++i) {
    const double t = static_cast<double>(i) / kSamples;
    nearest = std::min(nearest, signed_distance(shape, capsule.a + t * (capsule.b - capsule.a)));
  }
  return capsule.radius - nearest;
}

template <class Touch>
double depth_of(const Touch& touch) {
  return touch ? touch->depth : 0;
}

TEST(SignedDistance, OfACylinderOnAllSides) {
  const Cylinder cylinder{Vector3d(1, 0, 0), Vector3d::UnitY(), 0.1, 0.3};
  EXPECT_NEAR(signed_distance(cylinder, Vector3d(1.3, 0, 0)), 0.2, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, Vector3d(1, 0.5, 0.02)), 0.2, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, Vector3d(1, 0.34, 0.13)), 0.05, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, Vector3d(1, 0.29, 0.02)), -0.01, 1e-12);
  EXPECT_NEAR(signed_distance(cylinder, Vector3d(1.09, 0, 0)), -0.01, 1e-12);
}

TEST(SignedDistance, OfAWallOnAllSides) {
  const Wall wall{-1, 0.05, 0.2};
  EXPECT_NEAR(signed_distance(wall, Vector3d(-0.9, 7, 0.1)), 0.05, 1e-12);
  EXPECT_NEAR(signed_distance(wall, Vector3d(-1, -7, 0.3)), 0.1, 1e-12);
  EXPECT_NEAR(signed_distance(wall, Vector3d(-1.08, 0, 0.24)), 0.05, 1e-12);
  EXPECT_NEAR(signed_distance(wall, Vector3d(-1.04, 0, 0.1)), -0.01, 1e-12);
  EXPECT_NEAR(signed_distance(wall, Vector3d(-1, 0, 0.19)), -0.01, 1e-12);
}

TEST(CapsuleOnCylinder, FindsTheDeepestPoint) {
  Points points(1);
  int touching = 0;
  for (int i = 0; i < kTrials; ++i) {
    const Cylinder cylinder{points.point(0.1), points.point(1).normalized(), 0.09, 0.1};
    const Capsule capsule{points.point(0.25), points.point(0.25), 0.02};
    const auto touch = touch_cylinder(cylinder, capsule);
    EXPECT_NEAR(depth_of(touch), std::max(0.0, brute_depth(cylinder, capsule)), 3e-4);
    touching += touch.has_value() ? 1 : 0;
  }
  EXPECT_GT(touching, kTrials / 5);
}

TEST(CapsuleOnCylinder, NormalPointsOutOfTheMantle) {
  const Cylinder cylinder{Vector3d::Zero(), Vector3d::UnitY(), 0.09, 0.3};
  const Capsule above{Vector3d(-0.1, 0.1, 0.1), Vector3d(0.1, 0.1, 0.1), 0.013};
  bool at_b = true;
  const auto touch = touch_cylinder(cylinder, above, &at_b);
  ASSERT_TRUE(touch);
  EXPECT_NEAR((touch->normal - Vector3d::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR(touch->depth, 0.003, 1e-12);
  EXPECT_NEAR((touch->point - Vector3d(0, 0.1, 0.0885)).norm(), 0, 1e-12);
  EXPECT_FALSE(at_b);
  EXPECT_FALSE(
      touch_cylinder(cylinder, {Vector3d(-0.1, 0.1, 0.11), Vector3d(0.1, 0.1, 0.11), 0.013}));
}

TEST(CapsuleOnWall, FindsTheDeepestPoint) {
  Points points(2);
  int touching = 0;
  for (int i = 0; i < kTrials; ++i) {
    const Wall wall{points.number(0.05), 0.0005, 0.1 + points.number(0.05)};
    const Capsule capsule{points.point(0.2), points.point(0.2), 0.02};
    const auto touch = touch_wall(wall, capsule);
    EXPECT_NEAR(depth_of(touch), std::max(0.0, brute_depth(wall, capsule)), 3e-4);
    touching += touch.has_value() ? 1 : 0;
  }
  EXPECT_GT(touching, kTrials / 5);
}

TEST(CapsuleOnCapsule, FindsTheClosestPoints) {
  Points points(3);
  int touching = 0;
  for (int i = 0; i < 100; ++i) {
    const Capsule first{points.point(0.1), points.point(0.1), 0.02};
    const Capsule second{points.point(0.1), points.point(0.1), 0.015};
    double nearest = std::numeric_limits<double>::infinity();
    for (int s = 0; s <= 300; ++s) {
      const Vector3d p = first.a + s / 300.0 * (first.b - first.a);
      const Vector3d d = second.b - second.a;
      const double t = std::clamp((p - second.a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - second.a - t * d).norm());
    }
    const auto touch = touch_capsules(first, second);
    EXPECT_NEAR(depth_of(touch), std::max(0.0, 0.035 - nearest), 1e-3);
    if (touch) {
      ++touching;
      EXPECT_NEAR(touch->normal.norm(), 1, 1e-12);
    }
  }
  EXPECT_GT(touching, 20);
}

TEST(CapsuleOnCapsule, SpheresAndParallels) {
  const Capsule sphere{Vector3d(0, 0, 0.03), Vector3d(0, 0, 0.03), 0.02};
  const Capsule rod{Vector3d(-1, 0, 0), Vector3d(1, 0, 0), 0.02};
  EXPECT_NEAR(touch_capsules(sphere, rod).value().depth, 0.01, 1e-12);
  EXPECT_NEAR(touch_capsules(rod, sphere).value().normal.z(), 1, 1e-12);
  const Capsule shifted{Vector3d(-1, 0, 0.03), Vector3d(1, 0, 0.03), 0.02};
  EXPECT_NEAR(touch_capsules(rod, shifted).value().depth, 0.01, 1e-12);
  EXPECT_FALSE(touch_capsules(rod, {Vector3d(1.1, 0, 0), Vector3d(2, 0, 0), 0.02}));
}

/// Lowest point of a cylinder's rims.
double lowest_rim(const Cylinder& cylinder) {
  double lowest = std::numeric_limits<double>::infinity();
  const Vector3d side = cylinder.axis.unitOrthogonal();
  for (int i = 0; i < kSamples; ++i) {
    const Eigen::AngleAxisd turn(2 * 3.14159265358979 * i / kSamples, cylinder.axis);
    for (const double end : {-1.0, 1.0}) {
      lowest = std::min(lowest, (cylinder.centre + end * cylinder.half_length * cylinder.axis +
                                 cylinder.radius * (turn * side))
                                    .z());
    }
  }
  return lowest;
}

TEST(CylinderOnGround, DeepestRimMatchesItsLowestPoint) {
  Points points(4);
  for (int i = 0; i < kTrials; ++i) {
    const Cylinder cylinder{Vector3d(0, 0, 0.1 + points.number(0.1)), points.point(1).normalized(),
                            0.09, 0.3};
    double deepest = 0;
    for (const auto& touch : cylinder_on_ground(cylinder))
      deepest = std::max(deepest, depth_of(touch));
    EXPECT_NEAR(deepest, std::max(0.0, -lowest_rim(cylinder)), 1e-5);
  }
}

TEST(CylinderOnGround, LyingFlatTouchesAlongItsAxis) {
  const Cylinder cylinder{Vector3d(0, 0, 0.0895), Vector3d::UnitY(), 0.09, 0.3};
  for (const auto& touch : cylinder_on_ground(cylinder)) {
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->depth, 0.0005, 1e-12);
    EXPECT_NEAR(touch->normal.z(), 1, 1e-12);
  }
}

TEST(CylinderOnWall, TouchesItsFaceAndItsEdge) {
  const Wall wall{-1, 0.0005, 0.1};
  const Cylinder before{Vector3d(-0.911, 0, 0.09), Vector3d::UnitY(), 0.09, 0.3};
  for (const auto& touch : cylinder_on_wall(before, wall)) {
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->normal.x(), -1, 1e-12);
    EXPECT_NEAR(touch->depth, 0.0015, 1e-12);
  }
  const Cylinder on_top{Vector3d(-1, 0, 0.189), Vector3d::UnitY(), 0.09, 0.3};
  for (const auto& touch : cylinder_on_wall(on_top, wall)) {
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->normal.z(), -1, 1e-12);
    EXPECT_NEAR(touch->depth, 0.001, 1e-9);
  }
}

TEST(CylinderOnWall, AslantItTouchesWhereItsAxisPasses) {
  const Wall wall{-1, 0.0005, 0.1};
  const Vector3d axis = Vector3d(1, 1, 0).normalized();
  const AxisTouches touches = cylinder_on_wall({Vector3d(-0.9, 0, 0.188), axis, 0.09, 0.3}, wall);
  EXPECT_FALSE(touches[0]);
  EXPECT_FALSE(touches[2]);
  ASSERT_TRUE(touches[1]);
  EXPECT_NEAR(touches[1]->depth, 0.002, 1e-4);
  EXPECT_NEAR(touches[1]->point.y(), -0.1, 0.002);
}

}  // namespace
}  // namespace scarab::plant
