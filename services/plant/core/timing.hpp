#pragma once

#include <cstdint>
#include <string>

#include "services/plant/core/plant_config.hpp"

namespace scarab::plant {

/// The periods as whole nanoseconds and counts, so that times never drift.
struct Timing {
  std::int64_t step_ns = 0;
  std::int64_t sensor_period_ns = 0;
  std::int64_t steps_per_sample = 0;
  std::int64_t samples_per_tick = 0;
};

/// Throws std::invalid_argument unless every period is positive and each divides the next.
[[nodiscard]] Timing make_timing(const TimingConfig& config);

/// A time as a number of steps; 0 s are none. Throws std::invalid_argument, beginning with `name`,
/// unless it is a whole number of them.
[[nodiscard]] std::int64_t whole_steps(double time_s, std::int64_t step_ns,
                                       const std::string& name);

}  // namespace scarab::plant
