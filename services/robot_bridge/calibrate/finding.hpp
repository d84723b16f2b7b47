#pragma once

#include <optional>

#include "services/robot_bridge/calibrate/console.hpp"
#include "services/robot_bridge/core/calibration.hpp"

namespace scarab::bridge::calibrate {

/// What came of one joint.
struct Finding {
  enum class Outcome { kFound, kSkipped, kQuit };

  Outcome outcome = Outcome::kSkipped;
  JointCalibration calibration;  ///< of kFound
};

/// Of a key that ended the work on a joint.
[[nodiscard]] inline Finding ended_by(Key key) {
  return {key == Key::kQuit ? Finding::Outcome::kQuit : Finding::Outcome::kSkipped, {}};
}

}  // namespace scarab::bridge::calibrate
