#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/robot/robot_model.hpp"
#include "common/runtime/options.hpp"
#include "services/plant/core/plant_config.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/core/calibration.hpp"
#include "tools/emulator/faults/fault.hpp"

namespace scarab::emulator {

/// The command line.
struct EmulatorOptions {
  runtime::ServiceOptions service;  ///< `config` is the bridge's
  std::filesystem::path robot;
  std::filesystem::path plant;
  std::filesystem::path device;   ///< the link; empty: `device` in the run directory
  std::filesystem::path journal;  ///< empty: none
  std::filesystem::path control;  ///< the pipe; empty: `emulator` in the run directory, or none
  std::vector<Fault> faults;
  std::uint64_t seed = 1;  ///< of lost and flipped bytes
  bool no_bus_rate = false;
};

/// What the files say.
struct Configuration {
  robot::RobotModel robot;
  plant::PlantConfig plant;
  bridge::BridgeConfig bridge;
  bridge::Calibration calibration;
};

/// Reads them and holds them against each other. Throws config::Error.
[[nodiscard]] Configuration load_configuration(const EmulatorOptions& options);

}  // namespace scarab::emulator
