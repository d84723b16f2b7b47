#include <CLI/CLI.hpp>

#include "common/runtime/program.hpp"
#include "tools/search/commands.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"Searches for parameters with trials in this process (docs/search.md).",
               "scarab-search"};
  app.require_subcommand(1);
  app.footer(
      "Example:\n"
      "  scarab-search run config/search/beetle.yaml --out runs/search/beetle\n"
      "  scarab-search evaluate config/search/beetle.yaml --candidate runs/search/beetle "
      "--held-out\n"
      "  scarab-search write runs/search/beetle\n"
      "Exit codes: 0 success, 1 failure, 2 bad usage or configuration, 130 interrupted.");
  search::Command command;
  search::add_run(app, command);
  search::add_evaluate(app, command);
  search::add_write(app, command);
  search::add_check(app, command);
  search::add_schema(app, command);
  return runtime::run_program(app, argc, argv, [&] { return command(); });
}
