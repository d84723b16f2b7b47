#pragma once

#include <cstdint>
#include <string>

#include "services/supervisor/core/obstacle_trigger.hpp"
#include "services/supervisor/core/signals.hpp"
#include "services/supervisor/core/supervisor_config.hpp"

namespace scarab::supervisor {

/// The memory of every trigger's signal, one sample a tick.
struct ObstacleSignals {
  MovingWindow front_f_rad;       ///< mean angle of the two front F-joints
  MovingWindow supply_current_a;  ///< of the whole robot
  MovingWindow front_foot_n;      ///< mean normal force on the two front feet
};

/// A trigger's signal as it stands, averaged over one period of the CPG.
struct ObstacleReading {
  double value = 0;      ///< rad, A or N
  double threshold = 0;  ///< in the same unit
  bool beyond = false;   ///< on the side of a blocked object, and averaged over a whole period
};

/// When a trigger counts.
struct ObstacleTiming {
  unsigned confirm_ticks = 0;  ///< consecutive ticks beyond the threshold
  unsigned arm_ticks = 0;      ///< not before so many ticks of mode 1
};

/// All 0 for Trigger::kNone.
[[nodiscard]] ObstacleReading read(const ObstacleSignals& signals, const SupervisorConfig& config,
                                   Trigger trigger);
[[nodiscard]] ObstacleTiming timing_of(const SupervisorConfig& config, Trigger trigger);

/// Such as "AS 1.003 < 1.012 rad".
[[nodiscard]] std::string phrase(const ObstacleReading& reading, Trigger trigger);

}  // namespace scarab::supervisor
