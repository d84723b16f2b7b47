#pragma once

#include <memory>

#include "common/robot/robot_model.hpp"
#include "common/runtime/options.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge {

/// Serves as the robot, the tick master of the chain, until SIGINT or SIGTERM; then its motors are
/// off. `robot` with the ranges that its servos can reach. Throws bus::Error when the bus cannot be
/// joined.
void serve(const runtime::ServiceOptions& options, const BridgeConfig& config,
           const robot::RobotModel& robot, std::unique_ptr<Driver> driver);

}  // namespace scarab::bridge
