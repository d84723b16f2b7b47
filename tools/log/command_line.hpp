#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/log/log.hpp"
#include "tools/log/selection.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// What the command lines of several commands have in common.
namespace scarab::log {

/// The logs a command reads as one.
using LogPaths = std::vector<std::filesystem::path>;

/// Adds the positional argument FILE...
void add_logs(CLI::App& command, LogPaths& paths);

/// Adds an option that may be given several times, with one value each.
CLI::Option* add_repeatable(CLI::App& command, const std::string& name,
                            std::vector<std::string>& values, const std::string& help);

/// Adds --trial, --filter.
void add_selection(CLI::App& command, SelectionOptions& options);

/// Opens logs, with a progress line where they have to be scanned, and warns on stderr of cut ones.
Log open_logs(const LogPaths& paths);

/// Runs a command; what is wrong with its arguments (std::invalid_argument) becomes one line on
/// stderr and the exit code of bad usage. Throws std::runtime_error when stdout did not take all.
int run_checked(const std::function<int()>& command);

}  // namespace scarab::log
