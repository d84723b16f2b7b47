#pragma once

#include "common/robot/robot_model.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/tick_master.hpp"
#include "services/plant/core/plant_config.hpp"

namespace scarab::plant {

/// Serves as the simulated plant, the tick master of the chain, until SIGINT or SIGTERM.
/// Throws bus::Error when the bus cannot be joined.
void serve(const runtime::ServiceOptions& options, runtime::Pace pace, const PlantConfig& config,
           const robot::RobotModel& robot);

/// A robot may be described that cannot be simulated: throws std::invalid_argument saying why.
void require_simulable(const robot::RobotModel& robot, const PlantConfig& config);

}  // namespace scarab::plant
