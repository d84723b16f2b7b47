#pragma once

#include <memory>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "tools/emulator/boards/board.hpp"

namespace scarab::emulator {

/// The board that the bridge's driver expects at the other end of its line. Throws
/// std::invalid_argument: the driver needs no device (loopback), there is no board of that kind
/// here, or the configuration does not fit the robot.
[[nodiscard]] std::unique_ptr<Board> make_board(const bridge::BridgeConfig& config,
                                                const robot::RobotModel& robot,
                                                const bridge::Calibration& calibration, Note note);

}  // namespace scarab::emulator
