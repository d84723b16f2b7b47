#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "common/runtime/program.hpp"
#include "common/sample/field_path.hpp"
#include "tools/log/command_line.hpp"
#include "tools/log/commands.hpp"
#include "tools/log/comparison.hpp"
#include "tools/log/comparison_report.hpp"
#include "tools/log/progress_line.hpp"

namespace scarab::log {
namespace {

struct DiffArguments {
  std::filesystem::path a;
  std::filesystem::path b;
  std::vector<std::string> topics;
  Lenience lenience;
  bool json = false;
};

constexpr int kDifferent = 1;
constexpr int kTrouble = 2;

bool has_field(const sample::TypeModel& type, const std::string& field) try {
  sample::FieldPath(type, field);
  return true;
} catch (const bus::Error&) {
  return false;
}

std::vector<std::string> topics_of(const DiffArguments& arguments, const Log& a, const Log& b) {
  if (arguments.topics.empty()) return comparable_topics(a, b);
  for (const std::string& topic : arguments.topics) {
    if (a.find(topic) == nullptr && b.find(topic) == nullptr) {
      throw std::invalid_argument("no topic " + topic + " in either log");
    }
  }
  return arguments.topics;
}

/// A field that nothing has is a slip: what was meant to be ignored would count.
void check_ignored(const std::vector<std::string>& topics, const DiffArguments& arguments,
                   const Log& a, const Log& b) {
  for (const std::string& field : arguments.lenience.ignored) {
    const auto has_it = [&](const Log& log, const std::string& topic) {
      const LogChannel* channel = log.find(topic);
      return channel != nullptr && channel->type && has_field(*channel->type, field);
    };
    const bool known = std::any_of(topics.begin(), topics.end(), [&](const std::string& topic) {
      return has_it(a, topic) || has_it(b, topic);
    });
    if (!known) throw std::invalid_argument("--ignore " + field + ": no topic has such a field");
  }
}

int diff(const DiffArguments& arguments) {
  if (std::isnan(arguments.lenience.tolerance)) {
    throw std::invalid_argument("--tolerance nan: a number is meant");
  }
  const Log a = open_logs({arguments.a});
  const Log b = open_logs({arguments.b});
  const std::vector<std::string> topics = topics_of(arguments, a, b);
  check_ignored(topics, arguments, a, b);
  LogComparison comparison{arguments.a.string(), arguments.b.string(), {}};
  {
    ProgressLine line("comparing");
    for (const std::string& topic : topics) {
      line.say(topic);
      comparison.topics.push_back(compare_topic(a, b, topic, arguments.lenience));
    }
  }
  if (comparison.samples() == 0) {
    throw std::invalid_argument("nothing to compare: neither log has a sample of the topics");
  }
  arguments.json ? print_json(comparison, std::cout) : print_text(comparison, std::cout);
  return comparison.is_equal() ? runtime::kExitSuccess : kDifferent;
}

}  // namespace

void add_diff(CLI::App& app, Command& chosen) {
  auto* command =
      app.add_subcommand("diff", "whether two logs hold the same samples, wall-clock stamps aside");
  command->footer(
      "Without --topic: all topics but scarab/service_status, which tells of processes.\n"
      "Exit code: 0 equal, 1 different, 2 the logs could not be compared.\n"
      "Examples:\n"
      "  scarab-log diff a.mcap b.mcap\n"
      "  scarab-log diff a.mcap b.mcap --topic scarab/behaviour --ignore reason --tolerance 1e-9");
  auto arguments = std::make_shared<DiffArguments>();
  command->add_option("a", arguments->a, "one log: a file, or a directory of its files")
      ->type_name("A")
      ->required()
      ->check(CLI::ExistingPath);
  command->add_option("b", arguments->b, "the other")
      ->type_name("B")
      ->required()
      ->check(CLI::ExistingPath);
  add_repeatable(*command, "--topic", arguments->topics, "a topic to compare");
  add_repeatable(*command, "--ignore", arguments->lenience.ignored,
                 "a field that may differ, or the beginning of several (position_rad)");
  command
      ->add_option("--tolerance", arguments->lenience.tolerance, "numbers may differ by this much")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--json", arguments->json, "the result as a JSON object");
  command->callback([&chosen, arguments] {
    chosen = [arguments] {
      try {
        return run_checked([&] { return diff(*arguments); });
      } catch (const std::exception& error) {
        std::cerr << "scarab-log: " << error.what() << '\n';
        return kTrouble;  // like diff: trouble is not a difference
      }
    };
  });
}

}  // namespace scarab::log
