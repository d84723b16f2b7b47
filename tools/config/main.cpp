#include <CLI/CLI.hpp>

#include "common/runtime/program.hpp"
#include "tools/config/commands.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"Checks, shows and compares configuration files.", "scarab-config"};
  app.require_subcommand(1);
  app.footer("Example: scarab-config check config/*/*.yaml");
  config_tool::Command command;
  config_tool::add_check(app, command);
  config_tool::add_dump(app, command);
  config_tool::add_diff(app, command);
  config_tool::add_match(app, command);
  config_tool::add_schema(app, command);
  return runtime::run_program(app, argc, argv, [&] { return command(); });
}
