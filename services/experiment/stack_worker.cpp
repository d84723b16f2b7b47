#include <unistd.h>

#include <iostream>

#include "common/runtime/program.hpp"
#include "services/experiment/conductor.hpp"
#include "services/experiment/config.hpp"
#include "services/experiment/service.hpp"
#include "services/experiment/worker.hpp"

namespace scarab::experiment {

int serve_lines(const ExperimentOptions& options) {
  bus::Participant participant(options.bus.participant("experiment", 0));
  Conductor conductor(participant, options.expect, {}, FaultFile(options.fault_file));
  try {
    conductor.await_stack(std::chrono::seconds(options.ready_limit_s));
  } catch (const NotReady& error) {
    const std::string reason = std::string("the stack is not ready: ") + error.what();
    std::cout << error_row(std::nullopt, reason) << std::endl;
    return runtime::kExitFailure;
  } catch (const Interrupted&) {
    return runtime::kExitInterrupted;
  }
  const std::uint32_t first = conductor.next_trial();
  Worker worker;
  worker.input = STDIN_FILENO;
  worker.output = &std::cout;
  worker.interrupted = [&] { return conductor.interrupted(); };
  worker.run = [&](const TrialLine& line, std::uint32_t n) {
    return conductor.run(to_trial(line, first + n - 1),
                         std::chrono::seconds(options.silence_limit_s));
  };
  return work(worker);
}

}  // namespace scarab::experiment
