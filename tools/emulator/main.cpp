#include <CLI/CLI.hpp>
#include <iostream>

#include "common/runtime/logging.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/robot_bridge/config.hpp"
#include "tools/emulator/command_line.hpp"
#include "tools/emulator/emulator.hpp"
#include "tools/emulator/tell.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{
      "A robot to try the bridge on: its board's protocol on a pseudo-terminal, the plant's "
      "physics "
      "behind it.",
      "scarab-emulator"};
  app.footer(
      "Examples (deploy/scarab up --profile robot --emulated does the first):\n"
      "  scarab-emulator --robot config/robot/beetle.yaml --plant config/plant/beetle.yaml \\\n"
      "    --config config/robot_bridge/beetle-dynamixel.yaml --device /tmp/robot\n"
      "  scarab-emulator tell runs/20261122-1 silent TR0 for 2\n"
      "Its faults: scarab-emulator tell --help\n"
      "Exit codes: 0 stopped by a signal, or told; 1 it cannot run, 2 bad usage or configuration.");
  emulator::EmulatorOptions options;
  emulator::TellOptions tell;
  emulator::add_options(app, options, tell);

  return runtime::run_program(app, argc, argv, [&] {
    if (app.got_subcommand("tell")) {
      emulator::check_order(tell.words);
      emulator::tell(tell.where, tell.words);
      return runtime::kExitSuccess;
    }
    emulator::complete(options);
    const emulator::Configuration configuration = emulator::load_configuration(options);
    if (options.service.check) return runtime::kExitSuccess;
    if (options.service.dump_config) {
      std::cout << bridge::dump_config(configuration.bridge);
      return runtime::kExitSuccess;
    }
    const runtime::SignalBlock signals;
    runtime::set_up_logging("emulator", options.service.instance, options.service.log_level);
    emulator::emulate(options, configuration);
    return runtime::kExitSuccess;
  });
}
