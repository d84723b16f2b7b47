#include <CLI/CLI.hpp>
#include <iostream>

#include "common/runtime/logging.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/supervisor/config.hpp"
#include "services/supervisor/service.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"The behaviour supervisor: robot state in, behaviour out.", "scarab-supervisor"};
  app.footer(
      "Example (deploy/scarab up does this, with the others):\n"
      "  scarab-supervisor --config config/supervisor/beetle.yaml\n"
      "Exit codes: 0 stopped by a signal, 1 it cannot run, 2 bad usage or configuration.");
  runtime::ServiceOptions options;
  runtime::add_service_options(app, options);
  app.get_option("--config")->required();

  return runtime::run_program(app, argc, argv, [&] {
    const auto supervisor = supervisor::load_config(options.config);
    if (options.check) return runtime::kExitSuccess;
    if (options.dump_config) {
      std::cout << supervisor::dump_config(supervisor);
      return runtime::kExitSuccess;
    }
    const runtime::SignalBlock signals;
    runtime::set_up_logging("supervisor", options.instance, options.log_level);
    supervisor::serve(options, supervisor);
    return runtime::kExitSuccess;
  });
}
