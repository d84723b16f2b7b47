#pragma once

#include "common/bus/topics.hpp"
#include "common/runtime/status_board.hpp"
#include "tools/drive/live.hpp"

/// IDL types -> what the view shows. No I/O.
namespace scarab::drive {

void see(Live& live, const scarab_RobotState& state);
void see(Live& live, const scarab_Behaviour& behaviour);

/// All reports there are; `tick_master` is who writes robot_state, empty: nobody.
void see(Live& live, const runtime::StatusBoard& board, const std::string& tick_master);

}  // namespace scarab::drive
