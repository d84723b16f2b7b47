#pragma once

#include <filesystem>
#include <vector>

#include "common/runtime/options.hpp"

namespace scarab::logger {

/// The command line of scarab-logger.
struct LoggerOptions {
  runtime::ServiceOptions service;
  std::filesystem::path output;               ///< the log; `.active` is added until it is closed
  std::vector<std::filesystem::path> attach;  ///< files to put into the log
};

}  // namespace scarab::logger
