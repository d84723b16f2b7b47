#pragma once

#include <cstddef>
#include <vector>

#include "common/bus/topics.hpp"
#include "common/robot/robot_model.hpp"
#include "services/plant/core/observation.hpp"
#include "services/plant/core/trial_spec.hpp"
#include "services/plant/core/world_truth.hpp"

/// IDL types <-> core types of the plant. No I/O; headers are the caller's.
namespace scarab::plant {

inline constexpr std::size_t kContactsMost = 96;  // bound of WorldState.contacts

TrialSpec to_trial_spec(const scarab_Trial& trial);

/// Fills all but header and phase. Joints that the robot lacks are marked as absent.
void fill(scarab_RobotState& state, const Observation& observation, const robot::RobotModel& robot);

/// Fills all but the header. `contacts` becomes the storage that state.contacts points into and
/// must outlive its use.
void fill(scarab_WorldState& state, const WorldTruth& truth, std::vector<scarab_Contact>& contacts);

}  // namespace scarab::plant
