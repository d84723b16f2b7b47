#pragma once

#include "services/logger/config.hpp"
#include "services/logger/options.hpp"

namespace scarab::logger {

/// Records every topic of the domain until SIGINT or SIGTERM, then takes what is left and closes
/// the log. Throws bus::Error when the bus cannot be joined and mcap::FileError when the log cannot
/// be written.
void serve(const LoggerOptions& options, const LoggerConfig& config);

}  // namespace scarab::logger
