#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace scarab::runtime {

/// What is wrong with a command line, in one line without the program's name. A word that the
/// program does not know is named, with the command or option that may have been meant.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace scarab::runtime
