#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <tuple>

#include "common/config/json_object.hpp"
#include "common/runtime/program.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/process_list.hpp"
#include "tools/topic/session.hpp"

namespace scarab::topic {
namespace {

struct PsOptions {
  double timeout_s = 1.5;
  bool json = false;
};

int ps(const runtime::BusOptions& bus_options, const PsOptions& options) {
  Session session(bus_options);
  const auto processes = process_list(session.settle(milliseconds(options.timeout_s)));
  session.output().write(options.json ? process_json(processes) : process_table(processes));
  session.output().flush();
  return runtime::kExitSuccess;
}

}  // namespace

void add_ps(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<PsOptions>();
  CLI::App& command =
      *app.add_subcommand("ps", "the processes that take part in the domain, and on which hosts");
  command.add_flag("--json", options->json, "a line of JSON");
  add_seconds(command, "--timeout", options->timeout_s, "s to look for somebody at most");
  command.footer(
      "A process that does not tell its name, number or host (of another vendor) has - there.\n"
      "Examples:\n"
      "  scarab-topic ps\n"
      "  scarab-topic ps --interface eth0 --json\n"
      "Exit codes: 0 done, 1 failed, 2 bad usage, 130 interrupted.");
  command.callback(
      [&choice, options] { choice.run = [&choice, options] { return ps(choice.bus, *options); }; });
}

}  // namespace scarab::topic
