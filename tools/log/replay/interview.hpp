#pragma once

#include <ostream>

#include "tools/log/log.hpp"
#include "tools/log/replay/options.hpp"

namespace scarab::log {

/// Runs a service of the chain against a recorded robot, and holds its answers against the recorded
/// ones; returns the program's exit code: 0 only if every recorded answer came again.
///
/// Plays the tick master and everybody else in the log: tells each trial, waits until the service
/// says that it is ready, then asks tick after tick, each after the answer to the one before (or,
/// at a speed, when its time has come). A tick that the log lacks ends its trial: a service's
/// answers depend on all questions before. A trial whose number the service has seen already is
/// told under the next one. Throws std::invalid_argument, std::runtime_error saying who is silent,
/// bus::Error, mcap::Error. Needs a runtime::SignalBlock made before.
int interview(const Log& log, const ReplayOptions& replay, const InterviewOptions& options,
              std::ostream& out);

}  // namespace scarab::log
