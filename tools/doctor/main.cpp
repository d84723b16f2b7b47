#include <CLI/CLI.hpp>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/doctor/survey.hpp"

using namespace scarab;

int main(int argc, char** argv) {
  CLI::App app{
      "Prints as JSON who is on a DDS domain, as seen from one interface, and which writers and "
      "readers do not meet, and why.",
      "scarab-doctor"};
  runtime::BusOptions options;
  double timeout_s = 1.0;
  std::uint32_t participants = 1;
  runtime::add_bus_options(app, options);
  app.add_option("--timeout", timeout_s, "s to look for somebody at most")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 3600.0));
  app.add_option("--participants", participants,
                 "look on until so many have been seen, and nothing is new")
      ->capture_default_str()
      ->check(CLI::Range(0U, 10000U));
  app.footer(
      "Example:\n"
      "  scarab-doctor --domain 0 --interface eth0\n"
      "deploy/scarab doctor puts it into words.\n"
      "Exit codes: 0 done, 1 failed (no such interface), 2 bad usage, 130 interrupted.");

  return runtime::run_program(app, argc, argv, [&] {
    const runtime::SignalBlock signals;
    const std::chrono::milliseconds timeout(static_cast<std::int64_t>(timeout_s * 1000.0));
    return doctor::look(options, timeout, participants);
  });
}
