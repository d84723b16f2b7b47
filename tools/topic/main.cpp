#include <CLI/CLI.hpp>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/topic/commands.hpp"

using namespace scarab;

namespace {

void add_topic_options(CLI::App& command, topic::EchoOptions& options, const char* count_help) {
  command.add_option("topic", options.topic, "such as scarab/robot_state")->required();
  command.add_option("--count", options.count, count_help)->check(CLI::PositiveNumber);
}

void add_timeout(CLI::App& command, double& timeout_s, const char* help) {
  command.add_option("--timeout", timeout_s, help)
      ->capture_default_str()
      ->check(CLI::Range(0.01, 3600.0));
}

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000.0));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Looks at DDS topics of any type.", "scarab-topic"};
  runtime::BusOptions bus_options;
  topic::ListOptions list;
  topic::EchoOptions echo;
  double timeout_s = 2.0;
  runtime::add_bus_options(app, bus_options);
  app.require_subcommand(1);
  app.fallthrough();
  app.footer(
      "Examples:\n"
      "  scarab-topic list --verbose\n"
      "  scarab-topic echo scarab/robot_state --count 1\n"
      "  scarab-topic echo scarab/behaviour --json\n"
      "  scarab-topic hz scarab/joint_command\n"
      "Exit codes: 0 done, 1 failed (no such topic, unknown type), 2 bad usage, 130 interrupted.");

  CLI::App* list_command = app.add_subcommand("list", "topics, their types, writers and readers");
  list_command->add_flag("-v,--verbose", list.verbose, "each endpoint with its QoS");
  add_timeout(*list_command, timeout_s, "s to look for somebody at most");
  CLI::App* echo_command = app.add_subcommand("echo", "print the samples of a topic as YAML");
  add_topic_options(*echo_command, echo, "samples; without it, until Ctrl-C");
  echo_command->add_flag("--json", echo.json, "one line of JSON a sample");
  add_timeout(*echo_command, timeout_s, "s to wait for a writer");
  CLI::App* rate_command = app.add_subcommand("hz", "print the rate of a topic, a line a second");
  add_topic_options(*rate_command, echo, "lines; without it, until Ctrl-C");
  add_timeout(*rate_command, timeout_s, "s to wait for a writer");

  return runtime::run_program(app, argc, argv, [&] {
    const runtime::SignalBlock signals;
    list.timeout = echo.timeout = milliseconds(timeout_s);
    if (list_command->parsed()) return topic::list(bus_options, list);
    if (rate_command->parsed()) return topic::rate(bus_options, echo);
    return topic::echo(bus_options, echo);
  });
}
