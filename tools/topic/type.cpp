#include <CLI/CLI.hpp>
#include <memory>

#include "common/bus/known_types.hpp"
#include "common/bus/topic_type.hpp"
#include "common/runtime/program.hpp"
#include "common/sample/idl_text.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/field_list.hpp"
#include "tools/topic/named_type.hpp"
#include "tools/topic/session.hpp"

namespace scarab::topic {
namespace {

struct TypeOptions {
  std::string topic;
  std::string name;
  double timeout_s = 2.0;
  bool names = false;  ///< of fields: without their types
};

/// Of the topic, or by name; of the project's own types without a look at the domain.
sample::TypeModel model_of(const runtime::BusOptions& bus_options, const TypeOptions& options) {
  if (const auto* known = bus::find_known_type(options.name)) {
    return bus::model_of(*known);
  }
  Session session(bus_options);
  const auto end = after(milliseconds(options.timeout_s));
  const bus::TopicType type = options.name.empty()
                                  ? session.type_of(session.wait_for_endpoints(options.topic, end))
                                  : find_named_type(session, options.name, end);
  return understood(type);
}

void print(const std::string& text) {
  Output output([] { return false; });
  output.write(text);
  output.flush();
}

/// The operand and options that `type` and `fields` share.
std::shared_ptr<TypeOptions> add_options(CLI::App& command) {
  const auto options = std::make_shared<TypeOptions>();
  auto* name = command.add_option("--name,--type", options->name,
                                  "of this type, such as scarab::RobotState, not of a topic");
  auto* topic = command.add_option("topic", options->topic, "such as scarab/robot_state");
  topic->excludes(name);
  add_seconds(command, "--timeout", options->timeout_s, "s to wait for the topic");
  return options;
}

void require_one(const TypeOptions& options) {
  if (options.topic.empty() && options.name.empty()) {
    throw CLI::RequiredError("a topic, or --name NAME");
  }
}

}  // namespace

void add_type(CLI::App& app, Choice& choice) {
  CLI::App& command = *app.add_subcommand("type", "the type of a topic, as IDL");
  const auto options = add_options(command);
  command.footer(
      "Examples:\n"
      "  scarab-topic type scarab/robot_state\n"
      "  scarab-topic type --name scarab::RobotState\n"
      "Exit codes: 0 done, 1 failed, 2 bad usage, 4 no such topic, 5 type unknown, 130 "
      "interrupted.");
  command.callback([&choice, options] {
    require_one(*options);
    choice.run = [&choice, options] {
      print(sample::idl_text(model_of(choice.bus, *options)));
      return runtime::kExitSuccess;
    };
  });
}

void add_fields(CLI::App& app, Choice& choice) {
  CLI::App& command =
      *app.add_subcommand("fields", "the fields of a topic's samples, and their types");
  const auto options = add_options(command);
  command.add_flag("--names", options->names, "without their types, for scripts");
  command.footer(
      "What --field and --filter of the other commands take.\n"
      "Examples:\n"
      "  scarab-topic fields scarab/robot_state\n"
      "  scarab-topic fields --name scarab::WorldState --names\n"
      "Exit codes: 0 done, 1 failed, 2 bad usage, 4 no such topic, 5 type unknown, 130 "
      "interrupted.");
  command.callback([&choice, options] {
    require_one(*options);
    choice.run = [&choice, options] {
      print(field_list(model_of(choice.bus, *options), options->names));
      return runtime::kExitSuccess;
    };
  });
}

}  // namespace scarab::topic
