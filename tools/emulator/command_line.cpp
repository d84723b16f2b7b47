#include "tools/emulator/command_line.hpp"

#include <CLI/CLI.hpp>
#include <limits>
#include <stdexcept>
#include <variant>

#include "tools/emulator/faults/fault_text.hpp"
#include "tools/emulator/tell.hpp"

namespace scarab::emulator {
namespace {

void add_fault_option(CLI::App& app, EmulatorOptions& options) {
  app.add_option_function<std::vector<std::string>>(
         "--fault",
         [&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             try {
               const FaultOrder order = parse_fault_order(text);
               if (const auto* fault = std::get_if<Fault>(&order)) options.faults.push_back(*fault);
             } catch (const std::invalid_argument& error) {
               throw CLI::ValidationError("--fault", error.what());
             }
           }
         },
         "a fault to have, such as \"silent TR0 at 3 for 2\"; may be given again")
      ->allow_extra_args(false)
      ->type_name("TEXT");
}

void add_tell(CLI::App& app, TellOptions& tell) {
  CLI::App* command = app.add_subcommand("tell", "tells a running emulator to misbehave");
  command->add_option("where", tell.where, "its run directory, or its control pipe")->required();
  command->add_option("words", tell.words, "the fault, such as: stuck TR0 for 2")->required();
  command->footer("Faults:\n" + fault_words_help() +
                  "Examples:\n"
                  "  scarab-emulator tell runs/20261122-1 silent TR0 for 2\n"
                  "  scarab-emulator tell runs/20261122-1 clear\n"
                  "Exit codes: 0 told, 1 nobody listens there, 2 no such fault.");
}

}  // namespace

void add_options(CLI::App& app, EmulatorOptions& options, TellOptions& tell) {
  runtime::add_service_options(app, options.service);
  app.get_option("--config")->description("the bridge's configuration: which board, and how");
  app.add_option("--robot", options.robot, "robot description (YAML)");
  app.add_option("--plant", options.plant, "the world behind the wire: plant configuration (YAML)");
  app.add_option("--device", options.device,
                 "link to the serial device [device in the run directory]");
  app.add_option("--journal", options.journal, "write what happens on the wire here (CSV)");
  app.add_option("--control", options.control,
                 "named pipe that takes faults [emulator in the run directory]");
  add_fault_option(app, options);
  app.add_option("--seed", options.seed, "of the bytes that faults lose and flip")
      ->capture_default_str();
  app.add_flag("--no-bus-rate", options.no_bus_rate,
               "answer at once, not at the rate that the bus has");
  add_tell(app, tell);
}

void complete(EmulatorOptions& options) {
  if (options.service.config.empty()) throw CLI::RequiredError("--config");
  if (options.robot.empty()) throw CLI::RequiredError("--robot");
  if (options.plant.empty()) throw CLI::RequiredError("--plant");
  const std::filesystem::path& run_dir = options.service.run_dir;
  const bool runs = !options.service.check && !options.service.dump_config;
  if (runs && options.device.empty() && run_dir.empty())
    throw CLI::RequiredError("--device or --run-dir");
  if (options.device.empty()) options.device = run_dir / "device";
  if (options.control.empty() && !run_dir.empty()) options.control = run_dir / kControlPipeName;
}

}  // namespace scarab::emulator
