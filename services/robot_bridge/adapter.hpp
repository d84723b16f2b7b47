#pragma once

#include "common/bus/topics.hpp"
#include "services/robot_bridge/core/readings.hpp"

/// IDL types <-> core types of the robot bridge. No I/O; headers are the caller's.
namespace scarab::bridge {

/// Fills all but header and phase. Numbers that nobody stands for are published as 0.
void fill(scarab_RobotState& state, const Readings& readings);

}  // namespace scarab::bridge
