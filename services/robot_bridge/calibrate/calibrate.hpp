#pragma once

#include "services/robot_bridge/calibrate/request.hpp"

namespace scarab::bridge::calibrate {

/// Does it, motors off however it ends. Returns the program's exit code; throws config::Error and
/// BadRequest for what cannot be done at all, DeviceError if the robot is lost, Interrupted.
[[nodiscard]] int calibrate(const Request& request);

}  // namespace scarab::bridge::calibrate
