#pragma once

#include <string>
#include <vector>

#include "common/runtime/options.hpp"

namespace scarab::operator_desk {

/// What a person can say: start, pause, step, stop, emergency-stop, reset.
std::vector<std::string> command_names();

/// Says it on scarab/operator once the tick master listens; returns the exit code, 1 if nobody
/// listens.
int tell(const runtime::BusOptions& bus_options, const std::string& command,
         const std::string& reason);

}  // namespace scarab::operator_desk
