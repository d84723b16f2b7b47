#include <CLI/CLI.hpp>
#include <iostream>

#include "common/config/error.hpp"
#include "common/config/robot_file.hpp"
#include "common/runtime/logging.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/plant/config.hpp"
#include "services/plant/service.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"The simulated robot and its world: joint commands in, robot state out.",
               "scarab-plant"};
  app.footer(
      "Example (deploy/scarab up does this, with the others):\n"
      "  scarab-plant --robot config/robot/beetle.yaml --config config/plant/beetle.yaml\n"
      "Exit codes: 0 stopped by a signal, 1 it cannot run, 2 bad usage or configuration.");
  runtime::ServiceOptions options;
  std::string robot_file;
  std::string pace = "lockstep";
  runtime::add_service_options(app, options);
  app.get_option("--config")->required();
  app.add_option("--robot", robot_file, "robot description (YAML)")->required();
  app.add_option("--pace", pace, "lockstep (as fast as it goes) or realtime (by the wall clock)")
      ->check(CLI::IsMember({"lockstep", "realtime"}))
      ->capture_default_str();

  return runtime::run_program(app, argc, argv, [&] {
    const auto robot = config::load_robot(robot_file);
    const auto plant = plant::load_config(options.config);
    try {
      plant::require_simulable(robot, plant);
    } catch (const std::invalid_argument& error) {
      throw config::Error(robot_file, {}, "(top level)", error.what());
    }
    if (options.check) return runtime::kExitSuccess;
    if (options.dump_config) {
      std::cout << plant::dump_config(plant);
      return runtime::kExitSuccess;
    }
    const runtime::SignalBlock signals;
    runtime::set_up_logging("plant", options.instance, options.log_level);
    plant::serve(options, pace == "lockstep" ? runtime::Pace::kLockstep : runtime::Pace::kRealTime,
                 plant, robot);
    return runtime::kExitSuccess;
  });
}
