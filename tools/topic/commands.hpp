#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "common/runtime/options.hpp"

namespace CLI {
class App;
}

/// The commands of scarab-topic. Each adds itself with its options and help to the program, and
/// puts what it does into the choice when the command line names it.
namespace scarab::topic {

/// What the command line asks for.
struct Choice {
  runtime::BusOptions bus;
  std::function<int()> run;  ///< prints to standard output and returns the exit code
};

void add_list(CLI::App& app, Choice& choice);
void add_info(CLI::App& app, Choice& choice);
void add_type(CLI::App& app, Choice& choice);
void add_fields(CLI::App& app, Choice& choice);
void add_echo(CLI::App& app, Choice& choice);
void add_hz(CLI::App& app, Choice& choice);
void add_bw(CLI::App& app, Choice& choice);
void add_delay(CLI::App& app, Choice& choice);
void add_pub(CLI::App& app, Choice& choice);
void add_ps(CLI::App& app, Choice& choice);
void add_wait(CLI::App& app, Choice& choice);

}  // namespace scarab::topic
