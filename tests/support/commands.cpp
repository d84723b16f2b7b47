#include "tests/support/commands.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/programs.hpp"

namespace scarab::test {

std::vector<std::string> commands_of(const std::string& program_name) {
  const auto help = run({program(program_name), "--help"});
  EXPECT_EQ(help.exit_code, 0) << program_name << help.err;
  std::vector<std::string> commands;
  std::istringstream lines(help.out);
  bool within = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("  ", 0) != 0) within = line == "Subcommands:";
    if (!within || line.rfind("  ", 0) != 0 || line[2] == ' ') continue;  // a note goes on
    commands.push_back(line.substr(2, line.find_first_of(" ,", 2) - 2));
  }
  return commands;
}

}  // namespace scarab::test
