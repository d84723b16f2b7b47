#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>

#include "common/runtime/program.hpp"
#include "tools/log/commands.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  // Whoever reads has enough: `| head`. Those that start us may ignore it, as Python does.
  std::signal(SIGPIPE, SIG_DFL);
  std::ios::sync_with_stdio(false);
  CLI::App app{"Looks into recorded logs (MCAP), mends, compares and replays them.", "scarab-log"};
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  scarab-log info runs/latest/trial.mcap\n"
      "  scarab-log cat runs/latest/trial.mcap --topic scarab/behaviour\n"
      "  scarab-log export runs/latest/trial.mcap --topic scarab/behaviour > behaviour.csv\n"
      "Exit codes: 0 done; 1 not a log, or diff found a difference; 2 bad usage or no such "
      "file; 130 interrupted.");
  log::Command command;
  log::add_info(app, command);
  log::add_cat(app, command);
  log::add_export(app, command);
  log::add_diff(app, command);
  log::add_recover(app, command);
  log::add_replay(app, command);
  log::add_attachments(app, command);
  return runtime::run_program(app, argc, argv, [&] { return command(); });
}
