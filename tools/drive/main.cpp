#include <CLI/CLI.hpp>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/drive/drive.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{
      "Drives the robot by hand, in this terminal: modes, strategies and the network's inputs, "
      "with "
      "the live state of the stack that is up. SPACE is the emergency stop; ? shows all keys.",
      "scarab-drive"};
  drive::DriveOptions options;
  options.trial = drive::trial_to_drive_in();
  runtime::add_bus_options(app, options.bus);
  app.add_option("--strategies", options.strategies, "the strategies of the menu")
      ->delimiter(',')
      ->type_name("A,B,C");
  app.add_flag("--trial", options.start_trial,
               "start a trial, if none runs; the options below are of the trials started here");
  runtime::add_trial_options(app, options.trial);
  app.remove_option(app.get_option("--trials"));
  app.footer(
      "Examples:\n"
      "  scarab-drive --trial --strategies soft,boxing,soft+hard\n"
      "  scarab-drive --trial --strategy walk-forward --height 0.06\n"
      "Exit codes: 0 quit with q, 2 bad usage or no terminal, 130 interrupted. Quitting leaves the "
      "stack as it is.");
  return runtime::run_program(app, argc, argv, [&] {
    const runtime::SignalBlock signals;
    return drive::drive(options);
  });
}
