#pragma once

#include <functional>

namespace CLI {
class App;
}

/// What the main function of every program has in common.
namespace scarab::runtime {

inline constexpr int kExitSuccess = 0;
inline constexpr int kExitFailure = 1;        ///< something failed at run time
inline constexpr int kExitInterrupted = 130;  ///< by SIGINT or SIGTERM, before the work was done
inline constexpr int kExitBadUsage = 2;  ///< command line or configuration; nothing was started

/// Parses the command line, then calls `body` and returns its exit code. Errors become one line on
/// stderr: a bad command line or configuration ends with kExitBadUsage, any other exception with
/// kExitFailure.
int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& body);

}  // namespace scarab::runtime
