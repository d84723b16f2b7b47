#pragma once

#include <string>
#include <vector>

namespace scarab::test {

/// The commands that a program's own help lists, such as `list` of scarab-topic; empty where it has
/// none. Expects that the help is a success.
std::vector<std::string> commands_of(const std::string& program_name);

}  // namespace scarab::test
