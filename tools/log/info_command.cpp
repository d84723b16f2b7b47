#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "common/runtime/program.hpp"
#include "tools/log/command_line.hpp"
#include "tools/log/commands.hpp"
#include "tools/log/extraction.hpp"
#include "tools/log/info.hpp"
#include "tools/log/progress_line.hpp"

namespace scarab::log {

void add_info(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("info", "what a log holds: files, trials, topics, time span");
  command->footer("Example: scarab-log info runs/latest/trial.mcap --json");
  auto paths = std::make_shared<LogPaths>();
  auto json = std::make_shared<bool>(false);
  add_logs(*command, *paths);
  command->add_flag("--json", *json, "as a JSON object");
  command->callback([&chosen, paths, json] {
    chosen = [paths, json] {
      return run_checked([&] {
        const Log log = open_logs(*paths);
        LogFacts facts;
        {
          ProgressLine line("counting ticks");
          facts = gather_facts(
              log, [&](std::uint64_t done, std::uint64_t total) { line.update(done, total); });
        }
        *json ? print_info_json(facts, std::cout) : print_info(facts, std::cout);
        return runtime::kExitSuccess;
      });
    };
  });
}

void add_attachments(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("attachments", "list the attached files, or write them out");
  command->footer("Example: scarab-log attachments trial.mcap --extract configuration");
  auto paths = std::make_shared<LogPaths>();
  auto folder = std::make_shared<std::string>();
  add_logs(*command, *paths);
  command->add_option("--extract", *folder, "write them below this folder")->type_name("DIR");
  command->callback([&chosen, paths, folder] {
    chosen = [paths, folder] {
      return run_checked([&] {
        const Log log = open_logs(*paths);
        for (const auto& file : log.files()) {
          if (folder->empty()) {
            for (const auto& attachment : file->summary().attachments) {
              std::cout << attachment.name << '\n';
            }
          } else {
            for (const auto& path : extract_attachments(*file, *folder)) {
              std::cout << path.string() << '\n';
            }
          }
        }
        return runtime::kExitSuccess;
      });
    };
  });
}

}  // namespace scarab::log
