#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>

/// Where two shapes touch: pure functions, world frame, m. Each returns nothing while the shapes
/// are apart. All are continuous in their arguments but for shapes that lie exactly parallel.
namespace scarab::plant {

/// One point of contact of a shape A with a shape B.
struct Touch {
  Eigen::Vector3d point;   ///< between the two surfaces
  Eigen::Vector3d normal;  ///< unit vector from A to B
  double depth = 0;        ///< penetration, > 0
};

/// All points within `radius` of the segment from `a` to `b`; a sphere where they coincide.
struct Capsule {
  Eigen::Vector3d a;
  Eigen::Vector3d b;
  double radius = 0;
};

/// Solid cylinder with flat ends.
struct Cylinder {
  Eigen::Vector3d centre;
  Eigen::Vector3d axis;  ///< unit vector
  double radius = 0;
  double half_length = 0;
};

/// Upright thin box without end along y: |x - x_m| <= half_thickness, z <= height.
struct Wall {
  double x = 0;
  double half_thickness = 0;
  double height = 0;
};

/// A: ground (z <= 0), B: sphere.
[[nodiscard]] std::optional<Touch> touch_ground(const Eigen::Vector3d& centre, double radius);

/// A: cylinder, B: the deepest point of the capsule. `at_b`, if given, tells of a touch whether
/// that point is the end b of the segment.
[[nodiscard]] std::optional<Touch> touch_cylinder(const Cylinder& cylinder, const Capsule& capsule,
                                                  bool* at_b = nullptr);

/// A: wall, B: the deepest point of the capsule; `at_b` as above.
[[nodiscard]] std::optional<Touch> touch_wall(const Wall& wall, const Capsule& capsule,
                                              bool* at_b = nullptr);

/// A and B: capsules. `a_at_b`, `b_at_b`: whether the closest point is the end b of A or of B.
[[nodiscard]] std::optional<Touch> touch_capsules(const Capsule& first, const Capsule& second,
                                                  bool* a_at_b = nullptr, bool* b_at_b = nullptr);

/// Contacts at fixed places along the cylinder's axis.
using AxisTouches = std::array<std::optional<Touch>, 3>;

/// A: ground, B: cylinder, at the rims of both ends and of the middle.
[[nodiscard]] AxisTouches cylinder_on_ground(const Cylinder& cylinder);

/// A: cylinder, B: wall, at the rims of both ends and where the axis passes the wall's top.
[[nodiscard]] AxisTouches cylinder_on_wall(const Cylinder& cylinder, const Wall& wall);

/// Distance from a point to the cylinder's surface, negative inside.
[[nodiscard]] double signed_distance(const Cylinder& cylinder, const Eigen::Vector3d& point);

/// Distance from a point to the wall's surface, negative inside.
[[nodiscard]] double signed_distance(const Wall& wall, const Eigen::Vector3d& point);

}  // namespace scarab::plant
