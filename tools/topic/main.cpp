#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/failure.hpp"

using namespace scarab;

namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  scarab-topic list\n"
    "  scarab-topic echo scarab/robot_state --once\n"
    "  scarab-topic hz scarab/joint_command\n"
    "  scarab-topic pub scarab/operator '{command: OPERATOR_PAUSE}'\n"
    "  scarab-topic COMMAND --help\n"
    "It takes part in the domain like any other program and looks at the topics of every DDS "
    "system\n"
    "whose writers send type information.\n"
    "Exit codes: 0 done, 1 failed, 2 bad usage, 3 what was waited for did not come in time, 4 no\n"
    "such topic, 5 type unknown, 130 interrupted.";

int run(const std::function<int()>& command) {
  const runtime::SignalBlock signals;
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is noticed where it is written to
  try {
    return command();
  } catch (const topic::Failure& failure) {
    std::cerr << "scarab-topic: " << failure.what() << '\n';
    return failure.exit_code();
  } catch (const topic::Interrupted&) {
    return runtime::kExitInterrupted;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Looks at DDS topics of any type, and publishes them.", "scarab-topic"};
  topic::Choice choice;
  runtime::add_bus_options(app, choice.bus);
  app.require_subcommand(1);
  app.fallthrough();
  for (const auto add : {topic::add_list, topic::add_info, topic::add_type, topic::add_fields,
                         topic::add_echo, topic::add_hz, topic::add_bw, topic::add_delay,
                         topic::add_pub, topic::add_ps, topic::add_wait}) {
    add(app, choice);
  }
  app.footer(kFooter);
  return runtime::run_program(app, argc, argv, [&] { return run(choice.run); });
}
