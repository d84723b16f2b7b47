#pragma once

#include <optional>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/core/calibration.hpp"

/// How a servo's calibration follows from where the servo stands. Pure. Servo angles are on the
/// servo's own scale, joint angles in the project's signs, all in rad.
namespace scarab::bridge::calibrate {

/// A joint moved by hand less than this has not been moved on purpose.
inline constexpr double kLeastMove_rad = 0.1;
/// A travel shorter than this has not been walked through.
inline constexpr double kLeastTravel_rad = 0.3;

/// The servo's angle where the joint's would be 0, if the servo stands at `servo_rad` while the
/// joint stands at `joint_rad`.
[[nodiscard]] double offset_of(double servo_rad, int direction, double joint_rad);

/// +1 or -1: how the servo turned while the joint moved in its positive direction; nothing if it
/// did not turn enough to tell.
[[nodiscard]] std::optional<int> direction_of(double servo_before_rad, double servo_after_rad);

/// The lowest and the highest angle seen.
class Travel {
 public:
  explicit Travel(double servo_rad) : min_rad_(servo_rad), max_rad_(servo_rad) {}
  void see(double servo_rad);

  [[nodiscard]] double min_rad() const { return min_rad_; }
  [[nodiscard]] double max_rad() const { return max_rad_; }
  [[nodiscard]] bool is_walked_through() const { return max_rad_ - min_rad_ >= kLeastTravel_rad; }

 private:
  double min_rad_;
  double max_rad_;
};

/// Of a servo that tells where it stands: the three findings put together. The offset is within the
/// range, which a joint whose end is its zero would miss by the noise of a reading.
[[nodiscard]] JointCalibration measured(double servo_rad, double joint_rad, int direction,
                                        const Travel& travel);

/// The servo and the joint at one moment.
struct Standing {
  double servo_rad = 0;
  double joint_rad = 0;
};

/// Of a servo that tells nothing and takes fractions of a travel: `nominal` says which angles its
/// ends were taken for while it was driven to two places where somebody looked at the joint. Those
/// two tell the direction and how long the travel really is. Nothing if they are less than
/// kLeastMove_rad apart.
[[nodiscard]] std::optional<JointCalibration> driven(const JointCalibration& nominal,
                                                     const Standing& first, const Standing& second);

/// Where to drive the joint for the second look: 0.5 rad from the first, or as far as its range
/// lets it, to the side with more room.
[[nodiscard]] double second_look_rad(const robot::Joint& joint, double first_rad);

/// Whether the servo reaches all of the joint's range, but for a hundredth of a rad.
[[nodiscard]] bool covers(const JointCalibration& c, const robot::Joint& joint);

}  // namespace scarab::bridge::calibrate
