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
  app.add_flag("--json", options.json, "print JSON");
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
  app.add_option("--timeout", options.timeout_s, "how long to wait, s")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();

  return runtime::run_program(app, argc, argv, [&] {
    const runtime::SignalBlock signals;
    return status::show(options);
  });
}
