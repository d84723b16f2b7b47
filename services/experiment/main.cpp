#include <CLI/CLI.hpp>

#include "common/runtime/logging.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "services/experiment/service.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"Runs trials on the stack that is up and reports the referee's verdicts.",
               "scarab-experiment"};
  app.footer(
      "Example (deploy/scarab run does this, with a stack):\n"
      "  scarab-experiment --expect plant=1,supervisor=1,premotor=1,logger=1 --trials 3\n"
      "Exit codes: 0 every trial succeeded, or --worker has run all; 1 one failed or the stack is "
      "not ready, 2 bad usage, 130 interrupted.");
  experiment::ExperimentOptions options;
  runtime::add_trial_options(app, options.trials);
  app.add_option("--results", options.results, "write a table of the trials here (CSV)");
  app.add_flag("--quiet", options.quiet, "print results only");
  runtime::add_worker_flag(app, options.worker);
  runtime::add_bus_options(app, options.bus);
  runtime::add_expect_option(app, options.expect);
  app.add_option("--ready-limit", options.ready_limit_s, "how long to wait for the stack, s")
      ->capture_default_str();
  app.add_option("--silence-limit", options.silence_limit_s, "how long a trial may be silent, s")
      ->capture_default_str();
  app.add_option("--fault-file", options.fault_file,
                 "a line in this file, once it is there, says why no trial can go on");

  return runtime::run_program(app, argc, argv, [&] {
    const runtime::SignalBlock signals;
    runtime::set_up_logging("experiment", 0, "warning");
    return options.worker ? experiment::serve_lines(options) : experiment::conduct(options);
  });
}
