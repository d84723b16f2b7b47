#include "services/experiment/service.hpp"

#include <vector>

#include "common/runtime/program.hpp"
#include "common/runtime/screen.hpp"
#include "common/runtime/text_file.hpp"
#include "services/experiment/conductor.hpp"
#include "services/experiment/core/report.hpp"

namespace scarab::experiment {
namespace {

Conductor::Listener listener_on(runtime::Screen& screen) {
  return {[&screen](const std::string& whom) { screen.progress("waits for " + whom); },
          [&screen](const BehaviourChange& change) { screen.detail(change_line(change)); },
          [&screen](const Progress& progress) {
            if (progress.time_s > 0) screen.progress(progress_line(progress));
          }};
}

}  // namespace

int conduct(const ExperimentOptions& options) {
  // A contradiction between options shows before anything is started.
  (void)make_trial(options.trials, 0, 1);
  bus::Participant participant(options.bus.participant("experiment", 0));
  runtime::Screen screen(options.quiet);
  Conductor conductor(participant, options.expect, listener_on(screen),
                      FaultFile(options.fault_file));
  std::vector<Outcome> outcomes;
  try {
    conductor.await_stack(std::chrono::seconds(options.ready_limit_s));
    const std::uint32_t first = conductor.next_trial();
    for (unsigned index = 0; index < options.trials.trials; ++index) {
      const auto trial = make_trial(options.trials, index, first + index);
      outcomes.push_back(conductor.run(trial, std::chrono::seconds(options.silence_limit_s)));
      screen.line(result_line(outcomes.back()));
      runtime::write_text(options.results, results_csv(outcomes));
      const unsigned left = options.trials.trials - index - 1;
      if (left > 0 && conductor.at_fault()) {
        screen.line("the series ends here: " + std::to_string(left) + " trials were not run");
        break;
      }
    }
  } catch (const NotReady& error) {
    screen.line(std::string("result: failure: the stack is not ready: ") + error.what());
    return runtime::kExitFailure;
  } catch (const Interrupted&) {
    screen.line("interrupted after " + std::to_string(outcomes.size()) + " of " +
                std::to_string(options.trials.trials) + " trials");
    return runtime::kExitInterrupted;
  }
  if (outcomes.size() > 1) screen.line(summary_line(outcomes));
  return all_succeeded(outcomes) ? runtime::kExitSuccess : runtime::kExitFailure;
}

}  // namespace scarab::experiment
