#include <CLI/CLI.hpp>
#include <iostream>

#include "common/config/robot_file.hpp"
#include "common/runtime/logging.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/robot_bridge/driver_choice.hpp"
#include "services/robot_bridge/service.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"A real robot in the plant's place: joint commands to its servos, its sensors out.",
               "scarab-robot-bridge"};
  app.footer(
      "Example (deploy/scarab up --profile robot does this, with the others):\n"
      "  scarab-robot-bridge --robot config/robot/beetle.yaml \\\n"
      "    --config config/robot_bridge/beetle-dynamixel.yaml --device /dev/ttyUSB0\n"
      "Exit codes: 0 stopped by a signal, 1 it cannot run, 2 bad usage or configuration.");
  runtime::ServiceOptions options;
  std::string robot_file;
  std::string device;
  std::string pace = "realtime";
  runtime::add_service_options(app, options);
  app.get_option("--config")->required();
  app.add_option("--robot", robot_file, "robot description (YAML)")->required();
  app.add_option("--device", device, "port of the robot, in place of the configured one");
  app.add_option("--pace", pace, "realtime: a robot follows the wall clock")
      ->check(CLI::IsMember({"lockstep", "realtime"}))
      ->capture_default_str();

  return runtime::run_program(app, argc, argv, [&] {
    if (pace == "lockstep") {
      throw CLI::ValidationError("--pace", "lockstep: a real robot waits for nobody; say realtime");
    }
    const auto config = bridge::load_config(options.config);
    const auto robot = config::load_robot(robot_file);
    const auto calibration = bridge::load_calibration(config.calibration, robot);
    auto driver = bridge::make_driver(options.config, config, robot, calibration, device);
    if (options.check) return runtime::kExitSuccess;
    if (options.dump_config) {
      std::cout << bridge::dump_config(config);
      return runtime::kExitSuccess;
    }
    const runtime::SignalBlock signals;
    runtime::set_up_logging("robot_bridge", options.instance, options.log_level);
    bridge::serve(options, config, bridge::within_reach(robot, calibration), std::move(driver));
    return runtime::kExitSuccess;
  });
}
