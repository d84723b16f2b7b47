#include <CLI/CLI.hpp>
#include <memory>

#include "common/config/json_object.hpp"
#include "common/runtime/program.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/session.hpp"
#include "tools/topic/topic_table.hpp"

namespace scarab::topic {
namespace {

// Each endpoint's process answers within milliseconds; one that hangs must not hold up the list.
constexpr std::chrono::milliseconds kTypePatience{200};
// With --names nobody waits for a stack of 30 processes: that is for completion on a Tab.
constexpr double kNamesTimeout_s = 0.3;
constexpr std::chrono::milliseconds kNamesQuiet{100};

struct ListOptions {
  double timeout_s = 1.5;
  bool watch = false;
  bool json = false;
  bool names = false;
  bool verbose = false;
};

std::string text_of(const DomainView& view, bus::TypeTexts& types, const ListOptions& options) {
  if (options.names) {
    std::string out;
    for (const std::string& topic : view.topics()) out += topic + "\n";
    return out;
  }
  const auto reports = topic_reports(view, [&](const auto& endpoint) { return types(endpoint); });
  if (!options.json) return topic_table(view, reports, Output::width(), options.verbose);
  std::vector<std::string> rows;
  for (const TopicReport& report : reports) rows.push_back(report_json(view, report));
  return config::json_list(rows) + "\n";
}

/// On a terminal over the last one; elsewhere one after the other.
void show(Output& output, const std::string& text, const ListOptions& options, bool first) {
  constexpr const char* kClearScreen = "\033[H\033[2J";
  if (Output::is_terminal() && !options.json) {
    output.write(kClearScreen);
  } else if (!first && !options.json) {
    output.write("\n");
  }
  output.write(text);
  output.flush();
}

int list(const runtime::BusOptions& bus_options, const ListOptions& options) {
  Session session(bus_options);
  bus::TypeTexts types(session.discovery(), kTypePatience);
  const auto limit = milliseconds(options.timeout_s);
  const DomainView view =
      options.names ? session.settle(limit, kNamesQuiet) : session.settle(limit);
  std::string shown = text_of(view, types, options);
  if (!options.watch) {
    session.output().write(shown);
    session.output().flush();
    return runtime::kExitSuccess;
  }
  show(session.output(), shown, options, true);
  while (!session.interrupted() && !session.output().closed()) {
    session.wait(after(std::chrono::seconds(1)));
    const std::string now = text_of(session.view(), types, options);
    if (now != shown) show(session.output(), now, options, false);
    shown = now;
  }
  return runtime::kExitSuccess;
}

}  // namespace

void add_list(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<ListOptions>();
  CLI::App& command = *app.add_subcommand("list", "topics, their types, writers and readers");
  auto* watch = command.add_flag("--watch", options->watch,
                                 "go on, and list again whenever something changes");
  auto* json = command.add_flag("--json", options->json, "a line of JSON with all that is known");
  command.add_flag("--names", options->names, "the topics' names only, within 0.3 s, for scripts")
      ->excludes(json)
      ->excludes(watch);
  command.add_flag("-v,--verbose", options->verbose, "each endpoint with its QoS");
  add_seconds(command, "--timeout", options->timeout_s, "s to look for somebody at most");
  command.footer(
      "Lines marked with ! say which writers send no type information, and which readers get\n"
      "nothing from which writers, and why.\n"
      "Examples:\n"
      "  scarab-topic list --watch\n"
      "  scarab-topic list --domain 7 --json\n"
      "Exit codes: 0 done (at Ctrl-C too with --watch), 1 failed, 2 bad usage, 130 interrupted.");
  command.callback([&choice, options, &command] {
    if (options->names && command.count("--timeout") == 0) options->timeout_s = kNamesTimeout_s;
    choice.run = [&choice, options] { return list(choice.bus, *options); };
  });
}

}  // namespace scarab::topic
