#pragma once

#include <cstddef>
#include <optional>
#include <variant>

namespace scarab::emulator {

/// A way in which the emulated robot can misbehave.
enum class FaultKind {
  kLose,     ///< bytes get lost, each with a probability, both ways
  kFlip,     ///< one bit of a byte flips, each byte with a probability, both ways
  kStuck,    ///< a joint's servo does not move: it holds where it is
  kSilent,   ///< a servo, the IMU or the whole board neither hears nor answers
  kLate,     ///< answers come so much later
  kUnplug,   ///< the device is gone
  kHot,      ///< a servo's temperature
  kCurrent,  ///< a servo draws so much more
  kTilt,     ///< added to the pitch that the robot measures
  kPose      ///< where a joint stands at the beginning of the next trial
};

/// Who falls silent: one servo (then `joint` is given), the IMU, or the whole board.
enum class SilentPart { kJoint, kImu, kBoard };

/// One fault, as somebody has asked for it.
struct Fault {
  FaultKind kind = FaultKind::kLose;
  std::size_t joint = 0;  ///< slot; of those kinds that have one
  SilentPart part = SilentPart::kBoard;
  double value = 0;  ///< probability, s, C, A or rad, by the kind
  /// From when on, s since the world's t = 0; none: from the moment it is asked for.
  std::optional<double> at_s;
  std::optional<double> for_s;  ///< how long; none: until it is cleared
};

/// No fault any more, neither present nor to come.
struct Clear {};

/// What one line of the control pipe, or one --fault, says.
using FaultOrder = std::variant<Fault, Clear>;

}  // namespace scarab::emulator
