#include "services/plant/core/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace scarab::plant {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTiny = 1e-12;
/// More than a closed form for nearly parallel axes is wrong by.
constexpr double kMargin = 1e-6;
constexpr double kGoldenRatio = 0.6180339887498949;
/// Square of the sine between axis and wall below which the place where they pass moves to the
/// middle.
constexpr double kParallel = 1e-3;

/// Signed distance and outward direction at a point.
struct Distance {
  double value;
  Vector3d outward;
};

Distance distance_from(const Cylinder& cylinder, const Vector3d& point) {
  const Vector3d offset = point - cylinder.centre;
  const double along = offset.dot(cylinder.axis);
  const Vector3d across = offset - along * cylinder.axis;
  const double radial = across.norm();
  const double side = radial - cylinder.radius;
  const double end = std::abs(along) - cylinder.half_length;
  const Vector3d side_out =
      radial > kTiny ? Vector3d(across / radial) : Vector3d(cylinder.axis.unitOrthogonal());
  const Vector3d end_out = along < 0 ? Vector3d(-cylinder.axis) : cylinder.axis;
  if (end <= 0 && (side > 0 || side >= end)) return {side, side_out};
  if (side <= 0) return {end, end_out};
  const double value = std::hypot(side, end);
  return {value, (side * side_out + end * end_out) / value};
}

Distance distance_from(const Wall& wall, const Vector3d& point) {
  const double dx = point.x() - wall.x;
  const double side = std::abs(dx) - wall.half_thickness;
  const double top = point.z() - wall.height;
  const Vector3d side_out(dx < 0 ? -1 : 1, 0, 0);
  if (top <= 0 && (side > 0 || side >= top)) return {side, side_out};
  if (side <= 0) return {top, Vector3d::UnitZ()};
  const double value = std::hypot(side, top);
  return {value, (side * side_out + top * Vector3d::UnitZ()) / value};
}

double clamp01(double t) { return std::clamp(t, 0.0, 1.0); }

/// Smallest value on [0, 1] of a convex function, by golden section.
template <class F>
double minimise_convex(const F& f) {
  double low = 0;
  double high = 1;
  double t1 = high - kGoldenRatio;
  double t2 = low + kGoldenRatio;
  double f1 = f(t1);
  double f2 = f(t2);
  for (int i = 0; i < 40; ++i) {
    if (f1 < f2) {
      high = t2;
      t2 = t1;
      f2 = f1;
      t1 = high - kGoldenRatio * (high - low);
      f1 = f(t1);
    } else {
      low = t1;
      t1 = t2;
      f1 = f2;
      t2 = low + kGoldenRatio * (high - low);
      f2 = f(t2);
    }
  }
  const double t = 0.5 * (low + high);
  if (f(0) <= f(t)) return 0;
  return f(1) <= f(t) ? 1 : t;
}

/// Place on the capsule's segment that is deepest in the cylinder, if the two may touch. Distance
/// to the mantle bounds the distance to the solid from below, so its minimum, a closed form, is the
/// answer wherever the mantle is nearest, and tells a capsule that is too far away.
std::optional<double> deepest(const Cylinder& cylinder, const Capsule& capsule) {
  const Vector3d& a = capsule.a;
  const Vector3d& b = capsule.b;
  const Vector3d offset = a - cylinder.centre;
  const Vector3d along = b - a;
  const Vector3d offset_across = offset - offset.dot(cylinder.axis) * cylinder.axis;
  const Vector3d along_across = along - along.dot(cylinder.axis) * cylinder.axis;
  const double square = along_across.squaredNorm();
  const double t = square > kTiny ? clamp01(-offset_across.dot(along_across) / square) : 0.5;
  const double side = (offset_across + t * along_across).norm() - cylinder.radius;
  if (side > capsule.radius + kMargin) return std::nullopt;
  const double end = std::abs((offset + t * along).dot(cylinder.axis)) - cylinder.half_length;
  if (end <= 0 && side >= end) return t;
  return minimise_convex([&](double s) { return signed_distance(cylinder, a + s * along); });
}

/// Place on the segment that is nearest to the wall, whose profile is a half strip. The distance is
/// convex and piecewise: its minimum lies at an end, nearest to an upper edge, at a border
/// of the profile or in its middle.
double deepest(const Wall& wall, const Capsule& capsule) {
  const Vector3d& a = capsule.a;
  const Vector3d& b = capsule.b;
  const Vector3d along = b - a;
  std::array<double, 8> candidates{0, 1};
  std::size_t count = 2;
  const auto consider = [&](double numerator, double denominator) {
    if (std::abs(denominator) > kTiny) candidates[count++] = clamp01(numerator / denominator);
  };
  const double square = along.x() * along.x() + along.z() * along.z();
  for (const double side : {-1.0, 1.0}) {
    const double edge = wall.x + side * wall.half_thickness;
    consider((edge - a.x()) * along.x() + (wall.height - a.z()) * along.z(), square);
    consider(edge - a.x(), along.x());
  }
  consider(wall.x - a.x(), along.x());
  consider(wall.height - a.z(), along.z());
  double best = 0;
  double smallest = signed_distance(wall, a);
  for (std::size_t i = 1; i < count; ++i) {
    const double value = signed_distance(wall, a + candidates[i] * along);
    if (value < smallest) {
      smallest = value;
      best = candidates[i];
    }
  }
  return best;
}

/// Places s, t in [0, 1] where the segments a1 + s d1 and a2 + t d2 are closest, offset = a1 - a2:
/// C. Ericson, Real-Time Collision Detection (2005), section 5.1.9. Parallel segments meet in the
/// first one's middle.
std::pair<double, double> closest_places(const Vector3d& d1, const Vector3d& d2,
                                         const Vector3d& offset) {
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(offset);
  if (a <= kTiny) return {0, e <= kTiny ? 0 : clamp01(f / e)};
  const double c = d1.dot(offset);
  if (e <= kTiny) return {clamp01(-c / a), 0};
  const double b = d1.dot(d2);
  const double denominator = a * e - b * b;
  const double s = denominator > kTiny * a * e ? clamp01((b * f - c * e) / denominator) : 0.5;
  const double t = (b * s + f) / e;
  if (t >= 0 && t <= 1) return {s, t};
  const double end = clamp01(t);
  return {clamp01((b * end - c) / a), end};
}

template <class Shape>
std::optional<Touch> touch_capsule(const Shape& shape, const Capsule& capsule, bool* at_b) {
  const std::optional<double> t = deepest(shape, capsule);
  if (!t) return std::nullopt;
  const Vector3d point = capsule.a + *t * (capsule.b - capsule.a);
  const Distance distance = distance_from(shape, point);
  if (at_b != nullptr) *at_b = *t >= 1;
  const double depth = capsule.radius - distance.value;
  if (depth <= 0) return std::nullopt;
  return Touch{point - (capsule.radius - 0.5 * depth) * distance.outward, distance.outward, depth};
}

}  // namespace

double signed_distance(const Cylinder& cylinder, const Vector3d& point) {
  return distance_from(cylinder, point).value;
}

double signed_distance(const Wall& wall, const Vector3d& point) {
  return distance_from(wall, point).value;
}

std::optional<Touch> touch_ground(const Vector3d& centre, double radius) {
  const double depth = radius - centre.z();
  if (depth <= 0) return std::nullopt;
  return Touch{Vector3d(centre.x(), centre.y(), -0.5 * depth), Vector3d::UnitZ(), depth};
}

std::optional<Touch> touch_cylinder(const Cylinder& cylinder, const Capsule& capsule, bool* at_b) {
  return touch_capsule(cylinder, capsule, at_b);
}

std::optional<Touch> touch_wall(const Wall& wall, const Capsule& capsule, bool* at_b) {
  return touch_capsule(wall, capsule, at_b);
}

std::optional<Touch> touch_capsules(const Capsule& first, const Capsule& second, bool* a_at_b,
                                    bool* b_at_b) {
  const Vector3d d1 = first.b - first.a;
  const Vector3d d2 = second.b - second.a;
  const auto [s, t] = closest_places(d1, d2, first.a - second.a);
  if (a_at_b != nullptr) *a_at_b = s >= 1;
  if (b_at_b != nullptr) *b_at_b = t >= 1;
  const Vector3d on_first = first.a + s * d1;
  const Vector3d between = second.a + t * d2 - on_first;
  const double distance = between.norm();
  const double depth = first.radius + second.radius - distance;
  if (depth <= 0) return std::nullopt;
  Vector3d normal = Vector3d::UnitZ();
  if (distance > kTiny) {
    normal = between / distance;
  } else if (d1.cross(d2).norm() > kTiny) {
    normal = d1.cross(d2).normalized();
  }
  return Touch{on_first + (first.radius - 0.5 * depth) * normal, normal, depth};
}

AxisTouches cylinder_on_ground(const Cylinder& cylinder) {
  AxisTouches out;
  const Vector3d& u = cylinder.axis;
  const Vector3d down = -Vector3d::UnitZ() + u.z() * u;  // in the plane of the rim
  const double tilt = down.norm();                       // cosine of the axis against the ground
  const Vector3d to_rim = tilt > kTiny ? Vector3d(cylinder.radius / tilt * down) : Vector3d::Zero();
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double along = (static_cast<double>(i) - 1) * cylinder.half_length;
    out[i] = touch_ground(cylinder.centre + along * u + to_rim, 0);
  }
  return out;
}

AxisTouches cylinder_on_wall(const Cylinder& cylinder, const Wall& wall) {
  const Vector3d& u = cylinder.axis;
  // Where the axis passes closest over the wall's top; a regularised quotient, so that it goes to
  // the middle as axis and wall become parallel.
  const Vector2d across(u.x(), u.z());
  const Vector2d offset(cylinder.centre.x() - wall.x, cylinder.centre.z() - wall.height);
  const double pass = std::clamp(-offset.dot(across) / (across.squaredNorm() + kParallel),
                                 -cylinder.half_length, cylinder.half_length);
  const std::array<double, 3> places = {-cylinder.half_length, pass, cylinder.half_length};
  AxisTouches out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vector3d centre = cylinder.centre + places[i] * u;
    const Distance distance = distance_from(wall, centre);
    const Vector3d in_rim_plane = distance.outward - distance.outward.dot(u) * u;
    const double depth = cylinder.radius * in_rim_plane.norm() - distance.value;
    if (depth > 0) {
      const Vector3d on_wall = centre - distance.value * distance.outward;
      out[i] = Touch{on_wall - 0.5 * depth * distance.outward, -distance.outward, depth};
    }
  }
  return out;
}

}  // namespace scarab::plant
