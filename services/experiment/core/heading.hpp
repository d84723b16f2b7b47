#pragma once

#include <array>
#include <optional>

namespace scarab::experiment {

/// Heading of a body: of its x axis in the horizontal plane, rad in [-pi, pi], + to the left.
/// `orientation_wxyz` is a unit quaternion, R_world_body.
double heading_rad(const std::array<double, 4>& orientation_wxyz);

/// How far a body has turned since the first sample, whole turns counted.
class Turn {
 public:
  /// The next sample; less than half a turn from the one before.
  void see(double heading_rad);

  /// Since the first sample, rad; 0 before the second.
  [[nodiscard]] double turned_rad() const { return turned_rad_; }
  /// The largest that |turned_rad()| has been.
  [[nodiscard]] double most_rad() const { return most_rad_; }

 private:
  std::optional<double> first_rad_;
  double turned_rad_ = 0;
  double most_rad_ = 0;
};

}  // namespace scarab::experiment
