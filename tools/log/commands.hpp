#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace scarab::log {

/// Runs the command that was chosen; returns the program's exit code.
using Command = std::function<int()>;

/// Each adds one subcommand, which puts itself into `chosen` when the user names it. `chosen` must
/// outlive the parsing.
void add_info(CLI::App& app, Command& chosen);
void add_cat(CLI::App& app, Command& chosen);
void add_export(CLI::App& app, Command& chosen);
/// Exit codes: 0 equal, 1 different, 2 trouble.
void add_diff(CLI::App& app, Command& chosen);
void add_recover(CLI::App& app, Command& chosen);
/// Exit codes: 0 done, or all answers equal; 1 others, or none.
void add_replay(CLI::App& app, Command& chosen);
void add_attachments(CLI::App& app, Command& chosen);

}  // namespace scarab::log
