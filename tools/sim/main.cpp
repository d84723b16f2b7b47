#include <CLI/CLI.hpp>

#include "common/config/robot_file.hpp"
#include "common/runtime/program.hpp"
#include "services/plant/config.hpp"
#include "services/premotor/config.hpp"
#include "services/supervisor/config.hpp"
#include "tools/sim/sim.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{"Runs trials with the cores of all services in one process.", "scarab-sim"};
  app.footer(
      "Example (deploy/scarab sim fills in the files):\n"
      "  scarab-sim --robot config/robot/beetle.yaml --plant config/plant/beetle.yaml \\\n"
      "    --premotor config/premotor/beetle.yaml --supervisor config/supervisor/beetle.yaml\n"
      "Exit codes: 0 every trial succeeded, or --worker has run all; 1 one failed, 2 bad usage or "
      "configuration, 130 interrupted.");
  sim::SimOptions options;
  std::string robot, plant, premotor, supervisor;
  runtime::add_trial_options(app, options.trials);
  app.add_option("--results", options.results, "write a table of the trials here (CSV)");
  app.add_flag("--quiet", options.quiet, "print results only");
  runtime::add_worker_flag(app, options.worker);
  app.add_option("--robot", robot, "robot description (YAML)")->required();
  app.add_option("--plant", plant, "plant configuration (YAML)")->required();
  app.add_option("--premotor", premotor, "premotor configuration (YAML)")->required();
  app.add_option("--supervisor", supervisor, "supervisor configuration (YAML)")->required();
  app.add_option("--output", options.output, "record all samples here (MCAP)");

  return runtime::run_program(app, argc, argv, [&] {
    sim::Configuration configuration;
    configuration.robot = config::load_robot(robot);
    configuration.plant = plant::load_config(plant);
    configuration.premotor = premotor::load_config(premotor);
    configuration.supervisor = supervisor::load_config(supervisor);
    return options.worker ? sim::serve_lines(options, configuration)
                          : sim::simulate(options, configuration);
  });
}
