#include <CLI/CLI.hpp>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/operator/operator.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"Tells the running stack what a person wants.", "scarab-operator"};
  runtime::BusOptions options;
  std::string command;
  std::string reason;
  runtime::add_bus_options(app, options);
  app.add_option("command", command, "what to do")
      ->required()
      ->check(CLI::IsMember(operator_desk::command_names()));
  app.add_option("--reason", reason, "why, for the log");
  return runtime::run_program(app, argc, argv, [&] {
    const runtime::SignalBlock signals;
    return operator_desk::tell(options, command, reason);
  });
}
