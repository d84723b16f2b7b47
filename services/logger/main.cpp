#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "common/runtime/logging.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/logger/config.hpp"
#include "services/logger/service.hpp"

using namespace scarab;

namespace {

/// A device would be read for ever, or have the log beside it.
std::string refuse_irregular(const std::string& file) {
  const bool is_irregular =
      std::filesystem::exists(file) && !std::filesystem::is_regular_file(file);
  return is_irregular ? file + " is no regular file" : "";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Records every topic of the domain into one MCAP file.", "scarab-logger"};
  app.footer("Example: scarab-logger --output trial.mcap --attach plant.yaml");
  logger::LoggerOptions options;
  runtime::add_service_options(app, options.service);
  app.add_option(
         "--output", options.output,
         "the log; FILE.active until it is closed (default: trial.mcap in the run directory)")
      ->type_name("FILE")
      ->check(refuse_irregular);
  app.add_option("--attach", options.attach, "file to put into the log; repeatable")
      ->type_name("FILE")
      ->check(CLI::ExistingFile)
      ->check(refuse_irregular);

  return runtime::run_program(app, argc, argv, [&] {
    const auto config = options.service.config.empty()
                            ? logger::LoggerConfig{}
                            : logger::load_config(options.service.config);
    if (options.service.dump_config) {
      std::cout << logger::dump_config(config);
      return runtime::kExitSuccess;
    }
    if (options.service.check) return runtime::kExitSuccess;
    if (options.output.empty() && options.service.run_dir.empty()) {
      throw CLI::RequiredError("--output (or --run-dir)");
    }
    if (options.output.empty()) options.output = options.service.run_dir / "trial.mcap";
    const runtime::SignalBlock signals;
    runtime::set_up_logging("logger", options.service.instance, options.service.log_level);
    logger::serve(options, config);
    return runtime::kExitSuccess;
  });
}
