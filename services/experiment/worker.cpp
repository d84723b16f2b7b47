#include "services/experiment/worker.hpp"

#include <optional>
#include <stdexcept>
#include <string>

#include "common/config/error.hpp"
#include "common/runtime/program.hpp"
#include "services/experiment/config.hpp"
#include "services/experiment/line_input.hpp"

namespace scarab::experiment {
namespace {

void write(const Worker& worker, const std::string& row) {
  *worker.output << row << '\n' << std::flush;
  if (!*worker.output) throw std::runtime_error("cannot write result rows");
}

/// The row of a trial that is what its seed makes it, or none: a fault of the stack is no result.
std::string row_of(const Worker& worker, const TrialLine& line, std::uint32_t n) {
  const Outcome outcome = worker.run(line, n);
  if (!outcome.judged) throw std::runtime_error(outcome.reason);
  if (!outcome.missed.empty()) throw std::runtime_error(outcome.missed);
  return result_row(line, outcome);
}

}  // namespace

int work(const Worker& worker) {
  LineInput input(worker.input, worker.interrupted);
  std::optional<std::uint64_t> index;
  try {
    for (std::uint32_t n = 1;; ++n) {
      index.reset();
      const auto text = input.next();
      if (!text) return runtime::kExitSuccess;
      const auto line = read_trial_line("trial line " + std::to_string(n), *text);
      index = line.index;
      write(worker, row_of(worker, line, n));
    }
  } catch (const Interrupted&) {
    return runtime::kExitInterrupted;
  } catch (const config::Error& error) {
    write(worker, error_row(std::nullopt, error.what()));
    return runtime::kExitBadUsage;
  } catch (const std::exception& error) {
    write(worker, error_row(index, error.what()));
    return runtime::kExitFailure;
  }
}

}  // namespace scarab::experiment
