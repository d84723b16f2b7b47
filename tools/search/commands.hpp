#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace scarab::search {

/// Runs the command that was chosen; returns the program's exit code.
using Command = std::function<int()>;

/// Each adds one subcommand, which puts itself into `chosen` when the user names it. `chosen` must
/// outlive the parsing.
void add_run(CLI::App& app, Command& chosen);
void add_evaluate(CLI::App& app, Command& chosen);
void add_write(CLI::App& app, Command& chosen);
void add_check(CLI::App& app, Command& chosen);
void add_schema(CLI::App& app, Command& chosen);

}  // namespace scarab::search
