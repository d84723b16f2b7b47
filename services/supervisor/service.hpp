#pragma once

#include "common/runtime/options.hpp"
#include "services/supervisor/core/supervisor_config.hpp"

namespace scarab::supervisor {

/// Serves as the behaviour supervisor until SIGINT or SIGTERM: robot_state k in, behaviour k out.
/// Throws bus::Error when the bus cannot be joined.
void serve(const runtime::ServiceOptions& options, const SupervisorConfig& config);

}  // namespace scarab::supervisor
