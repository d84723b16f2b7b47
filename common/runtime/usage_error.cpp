#include "common/runtime/usage_error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "common/config/suggestion.hpp"

namespace scarab::runtime {
namespace {

using Names = std::vector<std::string>;

bool everything(const CLI::App* /*command*/) { return true; }

Names command_names(const CLI::App& app) {
  Names names;
  for (const CLI::App* command : app.get_subcommands(everything)) {
    if (!command->get_group().empty()) names.push_back(command->get_name());  // else it is hidden
  }
  return names;
}

void add_option_names(const CLI::App& app, Names& names) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
}

/// Those of the program, and of the command that has been chosen.
Names option_names(const CLI::App& app) {
  Names names;
  add_option_names(app, names);
  for (const CLI::App* command : app.get_subcommands()) add_option_names(*command, names);
  return names;
}

std::optional<std::string> nearest(const std::string& word, const Names& names) {
  const auto near = config::closest(word, {names.begin(), names.end()});
  return near ? std::optional<std::string>(*near) : std::nullopt;
}

std::string unknown_option(const CLI::App& app, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const Names known = option_names(app);
  if (std::find(known.begin(), known.end(), name) != known.end()) {
    return "option '" + name + "' belongs before the command";
  }
  const auto near = nearest(name, known);
  return "unknown option '" + name + "'" + (near ? "; did you mean '" + *near + "'?" : "");
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
  const Names names = command_names(app);
  const auto near = nearest(word, names);
  if (near) return "unknown command '" + word + "'; did you mean '" + *near + "'?";
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  return "unknown command '" + word + "'; there are " + known;
}

/// CLI11 writes out where the range of a number ends that has no upper limit: in 309 digits.
std::string without_endless_range(const std::string& text) {
  constexpr std::size_t kLongestRange = 100;
  const std::size_t range = text.find(" not in range ");
  const bool is_endless = range != std::string::npos && text.size() - range > kLongestRange;
  return is_endless ? text.substr(0, range) + " is too small" : text;
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  // That a command or an option is missing often comes of one that is misspelt.
  const bool is_missing = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const bool is_too_much = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  const Names strangers = is_missing || is_too_much ? app.remaining(true) : Names{};
  if (strangers.empty()) return without_endless_range(error.what());
  const std::string& word = strangers.front();
  if (word.size() > 1 && word.front() == '-') return unknown_option(app, word);
  const bool has_command = !app.get_subcommands().empty() || command_names(app).empty();
  if (!has_command) return unknown_command(app, word);
  return is_too_much ? "unexpected argument '" + word + "'" : error.what();
}

}  // namespace scarab::runtime
