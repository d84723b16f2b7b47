#pragma once

#include <cstdint>

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"
#include "services/plant/core/observation.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/plant/core/stepper.hpp"

namespace scarab::plant {

/// What ideal sensors read after a step. The accelerometer sits at the rear trunk's origin.
[[nodiscard]] Observation measure(const Morphology& morphology, const MotionState& state,
                                  const Stepper& stepper, double gravity_m_s2);

/// Adds Gaussian noise: a pure function of (seed, sensor, sample index). Absent joints stay 0.
void add_noise(const SensorNoiseConfig& noise, const Morphology& morphology, std::uint64_t seed,
               std::uint64_t sample, Observation& observation);

}  // namespace scarab::plant
