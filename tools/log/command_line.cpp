#include "tools/log/command_line.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "common/runtime/program.hpp"
#include "tools/log/info.hpp"
#include "tools/log/progress_line.hpp"

namespace scarab::log {

void add_logs(CLI::App& command, LogPaths& paths) {
  command
      .add_option("file", paths,
                  "the log; of several, or a directory of them, all files are read as one")
      ->type_name("FILE")
      ->required()
      ->check(CLI::ExistingPath);
}

CLI::Option* add_repeatable(CLI::App& command, const std::string& name,
                            std::vector<std::string>& values, const std::string& help) {
  return command.add_option(name, values, help + "; repeatable")->allow_extra_args(false);
}

void add_selection(CLI::App& command, SelectionOptions& options) {
  command.add_option("--trial", options.trial, "only samples of this trial");
  command
      .add_option("--filter", options.filter,
                  "only samples for which this holds, such as \"header.tick > 100 AND mode = "
                  "'MODE_HARD_PUSH'\"")
      ->type_name("EXPRESSION");
}

Log open_logs(const LogPaths& paths) {
  ProgressLine line("reading " + paths.at(0).string());
  Log log(paths, [&](std::uint64_t done, std::uint64_t total) { line.update(done, total); });
  for (const auto& path : log.passed_over()) {
    std::cerr << "scarab-log: " << path.string() << ": passed over, for the file that was mended "
              << "from it is read\n";
  }
  warn_if_cut(log, std::cerr);
  return log;
}

int run_checked(const std::function<int()>& command) try {
  const int code = command();
  std::cout.flush();
  if (!std::cout) throw std::runtime_error("cannot write all of the output");
  return code;
} catch (const std::invalid_argument& error) {
  std::cerr << "scarab-log: " << error.what() << '\n';
  return runtime::kExitBadUsage;
}

}  // namespace scarab::log
