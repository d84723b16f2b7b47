#pragma once

#include <ostream>

#include "tools/log/log.hpp"
#include "tools/log/replay/options.hpp"

namespace scarab::log {

/// Publishes a log again on DDS, each topic with its type and QoS, at its own pace or another;
/// returns the program's exit code. What cannot be published is named on `errors`, and left out.
///
/// Refuses, unless forced, where somebody in the domain writes one of the topics already, or a tick
/// master would take the replayed commands for its own: it would move the robot. Ends when every
/// reliable reader has the last sample. Throws std::invalid_argument, bus::Error, mcap::Error.
/// Needs a runtime::SignalBlock made before.
int replay(const Log& log, const ReplayOptions& options, std::ostream& out, std::ostream& errors);

}  // namespace scarab::log
