#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/emulator/configuration.hpp"

namespace CLI {
class App;
}

namespace scarab::emulator {

/// The words of `scarab-emulator tell`.
struct TellOptions {
  std::filesystem::path where;
  std::vector<std::string> words;
};

/// Adds the options of the emulator itself and those of `tell`, a command of its own.
void add_options(CLI::App& app, EmulatorOptions& options, TellOptions& tell);

/// Once the command line is read and no command was given: fills in what follows from the run
/// directory. Throws CLI::ParseError for what is missing.
void complete(EmulatorOptions& options);

}  // namespace scarab::emulator
