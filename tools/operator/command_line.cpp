#include "tools/operator/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace scarab::operator_desk {
namespace {

using Command = supervisor::OperatorWord::Command;

constexpr unsigned kStepsMost = 1000;
constexpr std::size_t kNameMost = sizeof(scarab_Operator::strategy) - 1;

CLI::App& add_command(CLI::App& app, Order& order, scarab_OperatorCommand command,
                      const std::string& name, const std::string& help,
                      const std::string& example) {
  auto* added = app.add_subcommand(name, help);
  added->fallthrough();  // the bus options may stand after the command, too
  added->add_option("--reason", order.reason, "why, for the log");
  added->footer("Example:\n  scarab-operator " + example);
  added->callback([&order, command, name] {
    order.command = command;
    order.name = name;
  });
  return *added;
}

CLI::Validator input_range() {
  const auto check = [](const std::string& text) {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::abs(value) <= 1;  // not nan
    return good ? std::string() : "'" + text + "' is no number from -1 to 1";
  };
  return {check, "-1..1"};
}

/// As long as the topic's field.
CLI::Validator name_length() {
  const auto check = [](const std::string& text) {
    return text.size() <= kNameMost ? std::string()
                                    : "longer than " + std::to_string(kNameMost) + " characters";
  };
  return {check, ""};
}

void add_tick_master_commands(CLI::App& app, Order& order) {
  add_command(app, order, scarab_OPERATOR_START, "start", "go on after a pause", "start");
  add_command(app, order, scarab_OPERATOR_PAUSE, "pause",
              "hold the trial before its next tick; start or step goes on", "pause");
  auto& step =
      add_command(app, order, scarab_OPERATOR_STEP, "step", "one tick, or N, then pause", "step 5");
  step.add_option("n", order.times, "how many ticks")
      ->check(CLI::Range(1U, kStepsMost))
      ->capture_default_str();
  add_command(app, order, scarab_OPERATOR_STOP, "stop",
              "end the trial; its verdict is a failure, by the operator",
              "stop --reason 'wrong obstacle'");
  add_command(app, order, scarab_OPERATOR_EMERGENCY_STOP, "estop",
              "emergency stop: the robot holds still, until reset, whether a trial runs or not",
              "estop --reason smoke")
      .alias("emergency-stop");
  add_command(app, order, scarab_OPERATOR_RESET, "reset",
              "leave the safe stop: the robot homes slowly, then the trial goes on", "reset");
}

void add_supervisor_commands(CLI::App& app, Order& order) {
  add_command(app, order, scarab_OPERATOR_AUTOMATIC, "automatic",
              "the strategy decides again, from its approach on", "automatic");
  auto& strategy =
      add_command(app, order, scarab_OPERATOR_STRATEGY, "strategy",
                  "follow another strategy, from its approach on, until the trial ends",
                  "strategy boxing+hard");
  strategy.add_option("name", order.word.strategy, "a strategy of config/supervisor")
      ->required()
      ->check(name_length());
  auto& mode = add_command(app, order, scarab_OPERATOR_MODE, "mode",
                           "hold a mode, until automatic or strategy", "mode soft_push");
  const std::vector<std::string> names(supervisor::kModeNames.begin(),
                                       supervisor::kModeNames.end());
  const auto hold = [&order, names](const std::string& name) {
    const auto place = std::find(names.begin(), names.end(), name) - names.begin();
    order.word.mode = static_cast<supervisor::Mode>(place);
  };
  mode.add_option_function<std::string>("name", hold, "one of these")
      ->required()
      ->check(CLI::IsMember(names));
  auto& inputs = add_command(app, order, scarab_OPERATOR_INPUTS, "inputs",
                             "hold the network's inputs I1..I4, until automatic or strategy",
                             "inputs 1 -1 1 0.5");
  inputs.add_option("values", order.word.inputs, "I1 I2 I3 I4, each from -1 to 1")
      ->required()
      ->type_name("I1 I2 I3 I4")
      ->check(input_range());
}

}  // namespace

void add_commands(CLI::App& app, Order& order) {
  app.require_subcommand(0, 1);  // one is; see check_given, whose message is the better one
  add_tick_master_commands(app, order);
  add_supervisor_commands(app, order);
  app.footer(
      "Examples:\n"
      "  scarab-operator pause\n"
      "  scarab-operator mode forward --reason 'to the window'\n"
      "  scarab-operator --domain 3 estop\n"
      "It prints what holds then. Exit codes: 0 carried out, 1 refused or nobody there, 2 bad "
      "usage, 130 interrupted.");
}

void check_given(const Order& order) {
  if (order.name.empty()) throw CLI::RequiredError("a command, such as pause or estop,");
}

}  // namespace scarab::operator_desk
