#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/robot/robot_model.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/core/calibration.hpp"

namespace scarab::bridge {

/// The driver that the configuration names, not opened yet. `device`, unless empty, takes the place
/// of its configured port; `config_file` is named in errors. Throws config::Error if the driver
/// cannot serve this robot, or cannot do the safe stop that is asked for.
[[nodiscard]] std::unique_ptr<Driver> make_driver(const std::filesystem::path& config_file,
                                                  const BridgeConfig& config,
                                                  const robot::RobotModel& robot,
                                                  const Calibration& calibration,
                                                  const std::string& device);

}  // namespace scarab::bridge
