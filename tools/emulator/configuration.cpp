#include "tools/emulator/configuration.hpp"

#include <stdexcept>

#include "common/config/error.hpp"
#include "common/config/robot_file.hpp"
#include "services/plant/config.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "tools/emulator/boards/make_board.hpp"
#include "tools/emulator/world/world.hpp"

namespace scarab::emulator {
namespace {

void require_consistent(const Configuration& c, const EmulatorOptions& options) {
  try {
    (void)make_board(c.bridge, c.robot, c.calibration, [](std::string_view, const std::string&) {});
  } catch (const std::invalid_argument& error) {
    throw config::Error(options.service.config.string(), {}, "(top level)", error.what());
  }
  try {
    const World world(c.robot, c.plant, c.bridge.timing.sensor_period_s);
  } catch (const std::invalid_argument& error) {
    throw config::Error(options.plant.string(), {}, "(top level)", error.what());
  }
}

}  // namespace

Configuration load_configuration(const EmulatorOptions& options) {
  Configuration configuration;
  configuration.robot = config::load_robot(options.robot);
  configuration.plant = plant::load_config(options.plant);
  configuration.bridge = bridge::load_config(options.service.config);
  configuration.calibration =
      bridge::load_calibration(configuration.bridge.calibration, configuration.robot);
  require_consistent(configuration, options);
  return configuration;
}

}  // namespace scarab::emulator
