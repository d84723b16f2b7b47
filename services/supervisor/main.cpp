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
  runtime::ServiceOptions options;
  runtime::add_service_options(app, options);

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
