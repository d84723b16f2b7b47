#include <CLI/CLI.hpp>
#include <iostream>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/status/status.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"Shows what the services of the stack say of themselves.", "scarab-status"};
  status::StatusOptions options;
  runtime::add_bus_options(app, options.bus);
  app.add_flag("--json", options.json,
               "print a JSON document on one line, see tools/status/README.md");
  app.add_flag("--watch", options.watch, "again every period, until Ctrl-C");
  app.add_option("--period", options.period_s, "of --watch, s")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  app.add_option_function<std::string>(
         "--wait",
         [&](const std::string& text) {
           try {
             options.wait_for = runtime::parse_expectation(text);
           } catch (const std::invalid_argument& error) {
             throw CLI::ValidationError("--wait", error.what());
           }
         },
         "wait until these services are up, such as plant=1,premotor=1")
      ->type_name("NAME=COUNT,...");
  app.add_flag("--progress", options.progress,
               "of --wait: say on stderr what is missing, after 2 s and whenever that changes");
  app.add_option("--look", options.look_s, "look at least so long, s: longer makes rates truer")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  app.add_option("--timeout", options.timeout_s, "how long to wait, s")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  app.footer(
      "Examples:\n"
      "  scarab-status --domain 0\n"
      "  scarab-status --json --watch --period 0.5\n"
      "  scarab-status --wait plant=1,supervisor=1,premotor=1 --timeout 30\n"
      "deploy/scarab status adds the processes of the stack.\n"
      "Exit codes: 0 done, 1 nobody there, or somebody waited for is missing or faulty, 2 bad "
      "usage, 130 interrupted (--watch ends with 0).");

  return runtime::run_program(app, argc, argv, [&] {
    const runtime::SignalBlock signals;
    return options.watch ? status::watch(options) : status::show(options);
  });
}
