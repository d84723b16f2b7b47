#pragma once

#include <cstddef>

#include "common/robot/joints.hpp"
#include "services/robot_bridge/calibrate/console.hpp"
#include "services/robot_bridge/calibrate/finding.hpp"
#include "services/robot_bridge/calibrate/measures.hpp"
#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge::calibrate {

/// Where every servo stands, on its own scale, of a driver made with own_scales(). Throws
/// DeviceError if `joint` does not tell.
[[nodiscard]] double servo_angle(Driver& driver, std::size_t joint);

/// Calibration of a robot that tells where its joints are: a person moves them, motors off.
class ByHand {
 public:
  /// `driver`: made with own_scales(), open. `reference_rad`: the pose joints are put into.
  ByHand(Driver& driver, Console& console, const robot::JointVector& reference_rad)
      : driver_(driver), console_(console), reference_rad_(reference_rad) {}

  /// Asks the person to put the joint into the reference pose, to move it in its positive
  /// direction, and to both its ends. Throws DeviceError, Interrupted.
  [[nodiscard]] Finding find(std::size_t joint);

 private:
  struct Look {
    Key key = Key::kNone;
    double servo_rad = 0;
    Travel travel;  ///< seen while waiting
  };

  /// Shows the joint's angle until Enter, s or q.
  [[nodiscard]] Look watch(std::size_t joint);

  Driver& driver_;
  Console& console_;
  robot::JointVector reference_rad_;
};

}  // namespace scarab::bridge::calibrate
