#include "tools/sim/sim.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <vector>

#include "common/runtime/program.hpp"
#include "common/runtime/screen.hpp"
#include "common/runtime/text_file.hpp"
#include "services/experiment/adapter.hpp"
#include "services/experiment/core/report.hpp"
#include "services/experiment/worker.hpp"

namespace scarab::sim {
namespace {

std::atomic<bool> interrupted{false};  // set by the signal handler, the one thing it can reach

void interrupt(int) { interrupted = true; }

void listen_to_signals() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
}

experiment::Outcome run(const Configuration& configuration, const scarab_Trial& trial,
                        SampleLog& log, runtime::Screen& screen) {
  experiment::TrialWatch watch(trial);
  std::size_t shown = 0;
  Listener listener;
  listener.behaviour = [&](const scarab_Behaviour& behaviour) {
    watch.see(behaviour);
    const auto& changes = watch.outcome().changes;
    for (; shown < changes.size(); ++shown) screen.detail(experiment::change_line(changes[shown]));
  };
  listener.world = [&](const scarab_WorldState& world) {
    watch.see(world);
    if (world.header.tick > 0) {
      screen.progress(experiment::progress_line(watch.outcome().end));
    }
  };
  listener.interrupted = [] { return interrupted.load(); };
  run_trial(configuration, trial, log, listener);
  return watch.outcome();
}

/// The same without a screen.
experiment::Outcome run(const Configuration& configuration, const scarab_Trial& trial,
                        SampleLog& log) {
  experiment::TrialWatch watch(trial);
  Listener listener;
  listener.behaviour = [&](const scarab_Behaviour& behaviour) { watch.see(behaviour); };
  listener.world = [&](const scarab_WorldState& world) { watch.see(world); };
  listener.interrupted = [] { return interrupted.load(); };
  run_trial(configuration, trial, log, listener);
  if (interrupted) throw experiment::Interrupted{};
  return watch.outcome();
}

}  // namespace

int serve_lines(const SimOptions& options, const Configuration& configuration) {
  listen_to_signals();
  SampleLog log(options.output);
  experiment::Worker worker;
  worker.input = STDIN_FILENO;
  worker.output = &std::cout;
  worker.interrupted = [] { return interrupted.load(); };
  worker.run = [&](const experiment::TrialLine& line, std::uint32_t n) {
    return run(configuration, experiment::to_trial(line, n), log);
  };
  const int code = experiment::work(worker);
  log.close();
  return code;
}

int simulate(const SimOptions& options, const Configuration& configuration) {
  listen_to_signals();
  runtime::Screen screen(options.quiet);
  (void)make_trial(options.trials, 0, 1);  // contradictions show before a file is begun
  SampleLog log(options.output);
  std::vector<experiment::Outcome> outcomes;
  for (unsigned index = 0; index < options.trials.trials; ++index) {
    const auto trial = make_trial(options.trials, index, index + 1);
    const auto outcome = run(configuration, trial, log, screen);
    if (interrupted) break;
    outcomes.push_back(outcome);
    screen.line(experiment::result_line(outcome));
    runtime::write_text(options.results, experiment::results_csv(outcomes));
  }
  log.close();
  if (interrupted) {
    screen.line("interrupted after " + std::to_string(outcomes.size()) + " of " +
                std::to_string(options.trials.trials) + " trials");
    return runtime::kExitInterrupted;
  }
  if (outcomes.size() > 1) screen.line(experiment::summary_line(outcomes));
  return experiment::all_succeeded(outcomes) ? runtime::kExitSuccess : runtime::kExitFailure;
}

}  // namespace scarab::sim
