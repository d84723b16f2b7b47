#pragma once

#include <vector>

#include "services/supervisor/core/mode.hpp"
#include "services/supervisor/core/obstacle_trigger.hpp"

namespace scarab::supervisor {

/// What to do in a trial: pure data, filled from config/supervisor/*.yaml.
struct Strategy {
  Mode approach = Mode::kBackward;  ///< until the object is climbed
  /// Mode 1, on the object, and mode 2, at the obstacle (paper, section 3). With one entry there is
  /// no switch at the obstacle; with none the robot stays in `approach`.
  std::vector<Mode> push;
  /// What switches from mode 1 to mode 2, in order of preference: the first that the robot
  /// measures.
  std::vector<Trigger> obstacle = {Trigger::kFrontAngle};
};

}  // namespace scarab::supervisor
