#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace scarab::config_tool {

/// Runs the command that was chosen; returns the program's exit code.
using Command = std::function<int()>;

/// Each adds one subcommand, which puts itself into `chosen` when the user names it. `chosen` must
/// outlive the parsing.
/// Exit codes: 0 all files are right, 2 one is not.
void add_check(CLI::App& app, Command& chosen);
void add_dump(CLI::App& app, Command& chosen);
/// Exit codes: 0 equal, 1 different, 2 nothing could be compared.
void add_diff(CLI::App& app, Command& chosen);
/// Exit codes: 0 the files fit each other, 2 they do not.
void add_match(CLI::App& app, Command& chosen);
void add_schema(CLI::App& app, Command& chosen);

}  // namespace scarab::config_tool
