#pragma once

#include "services/plant/core/bodies.hpp"
#include "services/plant/core/morphology.hpp"
#include "services/plant/core/observation.hpp"
#include "services/plant/core/stepper.hpp"

namespace scarab::plant {

/// What ideal sensors read after a step. The accelerometer sits at the rear trunk's origin.
[[nodiscard]] Observation measure(const Morphology& morphology, const MotionState& state,
                                  const Stepper& stepper, double gravity_m_s2);

}  // namespace scarab::plant
