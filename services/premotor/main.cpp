#include <CLI/CLI.hpp>
#include <iostream>

#include "common/config/robot_file.hpp"
#include "common/runtime/logging.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/premotor/config.hpp"
#include "services/premotor/service.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"The neural premotor controller: behaviour in, joint commands out.",
               "scarab-premotor"};
  app.footer(
      "Example (deploy/scarab up does this, with the others):\n"
      "  scarab-premotor --robot config/robot/beetle.yaml --config config/premotor/beetle.yaml\n"
      "Exit codes: 0 stopped by a signal, 1 it cannot run, 2 bad usage or configuration.");
  runtime::ServiceOptions options;
  std::string robot_file;
  runtime::add_service_options(app, options);
  app.get_option("--config")->required();
  app.add_option("--robot", robot_file, "robot description (YAML)")->required();

  return runtime::run_program(app, argc, argv, [&] {
    const auto robot = config::load_robot(robot_file);
    const auto premotor = premotor::load_config(options.config);
    if (options.check) return runtime::kExitSuccess;
    if (options.dump_config) {
      std::cout << premotor::dump_config(premotor);
      return runtime::kExitSuccess;
    }
    const runtime::SignalBlock signals;
    runtime::set_up_logging("premotor", options.instance, options.log_level);
    premotor::serve(options, premotor, robot);
    return runtime::kExitSuccess;
  });
}
