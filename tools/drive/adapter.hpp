#pragma once

#include <map>
#include <string>

#include "common/bus/topics.hpp"
#include "common/runtime/status_board.hpp"
#include "tools/drive/live.hpp"

/// IDL types -> what the view shows. No I/O.
namespace scarab::drive {

void see(Live& live, const scarab_RobotState& state);
void see(Live& live, const scarab_Behaviour& behaviour);

/// All reports there are; `tick_master` is who writes robot_state, empty: nobody. Whether a trial
/// runs is judged by its newest robot_state, too: show that first.
void see(Live& live, const std::map<bus::Peer, runtime::ServiceReport>& reports,
         const std::string& tick_master);

}  // namespace scarab::drive
