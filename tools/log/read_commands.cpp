#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "common/runtime/program.hpp"
#include "tools/log/cat.hpp"
#include "tools/log/command_line.hpp"
#include "tools/log/commands.hpp"
#include "tools/log/output_file.hpp"
#include "tools/log/table.hpp"

namespace scarab::log {
namespace {

struct CatArguments {
  LogPaths paths;
  std::vector<std::string> topics;
  SelectionOptions selection;
  CatOptions options;
};

int cat(CatArguments& arguments) {
  const Log log = open_logs(arguments.paths);
  arguments.selection.topics = {arguments.topics.begin(), arguments.topics.end()};
  const Selection selection(log, arguments.selection);
  print_messages(log, selection, arguments.options, std::cout);
  return runtime::kExitSuccess;
}

struct ExportArguments {
  LogPaths paths;
  SelectionOptions selection;
  TableOptions table;
  std::string format = "csv";
  std::string output;
};

int write_table(ExportArguments& arguments) {
  const Log log = open_logs(arguments.paths);
  arguments.selection.topics = {arguments.table.topic};
  require_type(log, arguments.table.topic);
  const Selection selection(log, arguments.selection);
  const auto write = [&](std::ostream& out) {
    if (arguments.format == "json") {
      write_json(log, selection, arguments.table, out);
    } else {
      write_csv(log, selection, arguments.table, out);
    }
  };
  if (arguments.output.empty()) {
    write(std::cout);
  } else {
    write_file(arguments.output, write);
  }
  return runtime::kExitSuccess;
}

}  // namespace

void add_cat(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("cat", "messages as YAML or JSON, in the order of the log");
  command->footer(
      "Examples:\n"
      "  scarab-log cat trial.mcap --topic scarab/behaviour --filter \"mode = 'MODE_HARD_PUSH'\" "
      "-n 1\n"
      "  scarab-log cat trial.mcap --json --field header.tick --field position_rad[3]");
  auto arguments = std::make_shared<CatArguments>();
  add_logs(*command, arguments->paths);
  add_repeatable(*command, "--topic", arguments->topics, "only this topic");
  add_selection(*command, arguments->selection);
  add_repeatable(*command, "--field", arguments->selection.fields,
                 "only this part of each sample, such as header.tick, position_rad[3], contacts");
  command->add_option("-n", arguments->options.most, "so many messages at most")
      ->check(CLI::PositiveNumber.description(""))
      ->type_name("N");
  command->add_flag("--json", arguments->options.json, "one line of JSON a message");
  command->callback([&chosen, arguments] {
    chosen = [arguments] { return run_checked([&] { return cat(*arguments); }); };
  });
}

void add_export(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("export", "a topic as a table");
  command->footer(
      "Examples:\n"
      "  scarab-log export trial.mcap --topic scarab/robot_state --field header.tick --field "
      "position_rad\n"
      "  scarab-log export trial.mcap --topic scarab/world_state --format json --output "
      "world.json");
  auto arguments = std::make_shared<ExportArguments>();
  add_logs(*command, arguments->paths);
  command->add_option("--topic", arguments->table.topic, "the topic")->required();
  command->add_option("--format", arguments->format, "csv, or json: a list of objects")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  add_repeatable(*command, "--field", arguments->table.fields,
                 "a column, or the beginning of several (position_rad)");
  add_selection(*command, arguments->selection);
  command
      ->add_option("--elements", arguments->table.sequence_elements,
                   "csv: elements of each sequence to show beside its length")
      ->check(CLI::NonNegativeNumber.description(""))
      ->capture_default_str();
  command->add_flag("--times", arguments->table.times, "put log_time_ns and publish_time_ns first");
  command->add_option("--output", arguments->output, "write to this file, not to stdout")
      ->type_name("FILE");
  command->callback([&chosen, arguments] {
    chosen = [arguments] { return run_checked([&] { return write_table(*arguments); }); };
  });
}

}  // namespace scarab::log
