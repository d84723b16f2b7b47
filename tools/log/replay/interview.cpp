#include "tools/log/replay/interview.hpp"

#include "common/runtime/program.hpp"
#include "tools/log/replay/interviewer.hpp"

namespace scarab::log {

int interview(const Log& log, const ReplayOptions& replay, const InterviewOptions& options,
              std::ostream& out) {
  Interviewer interviewer(log, replay, options, out);
  try {
    interviewer.run();
  } catch (const Interrupted&) {
    interviewer.report();
    return runtime::kExitInterrupted;
  } catch (const Silence&) {
    interviewer.report();
    throw;
  }
  interviewer.report();
  return interviewer.all_equal() ? runtime::kExitSuccess : runtime::kExitFailure;
}

}  // namespace scarab::log
