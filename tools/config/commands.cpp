#include "tools/config/commands.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/config/document.hpp"
#include "common/config/error.hpp"
#include "tools/config/difference.hpp"
#include "tools/config/file_kind.hpp"
#include "tools/config/robot_files.hpp"

namespace scarab::config_tool {
namespace {

constexpr int kSuccess = 0;
constexpr int kDifferent = 1;
constexpr int kBadUsage = 2;

/// What the subcommands that read files are given.
struct Arguments {
  std::vector<std::string> files;
  std::string kind;  ///< empty: by the folder of each file

  [[nodiscard]] const FileKind& kind_of(const std::string& file) const {
    return kind.empty() ? config_tool::kind_of(file) : kind_named(kind);
  }
};

/// Runs `body`; what is wrong with a file or its kind is one line and kBadUsage.
template <class Body>
int reporting(const Body& body) {
  try {
    return body();
  } catch (const config::Error& error) {
    std::cerr << error.what() << '\n';
  } catch (const WrongKind& error) {
    std::cerr << "scarab-config: " << error.what() << '\n';
  }
  return kBadUsage;
}

int check(const Arguments& arguments) {
  int result = kSuccess;
  for (const std::string& file : arguments.files) {
    const int one = reporting([&] {
      (void)arguments.kind_of(file).resolve(file);
      std::cout << file << ": ok" << std::endl;  // in order with what goes to stderr
      return kSuccess;
    });
    if (one != kSuccess) result = one;
  }
  return result;
}

int dump(const Arguments& arguments) {
  const std::string& file = arguments.files.at(0);
  std::cout << arguments.kind_of(file).resolve(file);
  return kSuccess;
}

int diff(const Arguments& arguments) {
  const std::string& a = arguments.files.at(0);
  const std::string& b = arguments.files.at(1);
  const FileKind& kind = arguments.kind_of(a);
  const FileKind& other = arguments.kind_of(b);
  if (kind.name != other.name) {
    throw WrongKind(a + " is of kind " + std::string(kind.name) + ", " + b + " of kind " +
                    std::string(other.name) + ": nothing to compare");
  }
  const config::Document before = config::parse_text(a, kind.resolve(a));
  const config::Document after = config::parse_text(b, kind.resolve(b));
  const std::vector<std::string> lines = differences(before.root, after.root);
  for (const std::string& line : lines) std::cout << line << '\n';
  return lines.empty() ? kSuccess : kDifferent;
}

/// The place of a file of that kind among the files of a robot.
std::optional<std::filesystem::path>& slot_of(RobotFiles& files, std::string_view kind) {
  if (kind == "calibration") return files.calibration;
  if (kind == "plant") return files.plant;
  if (kind == "premotor") return files.premotor;
  if (kind == "robot") return files.robot;
  if (kind == "robot_bridge") return files.robot_bridge;
  if (kind == "supervisor") return files.supervisor;
  throw WrongKind("files of kind " + std::string(kind) + " go with any robot: nothing to match");
}

int match(const Arguments& arguments) {
  RobotFiles files;
  for (const std::string& file : arguments.files) {
    const FileKind& kind = kind_of(file);
    auto& slot = slot_of(files, kind.name);
    if (slot) {
      throw WrongKind(slot->string() + " and " + file + " are both of kind " +
                      std::string(kind.name) + "; name one file of a kind");
    }
    slot = file;
  }
  expect_match(files);
  std::cout << "the files match\n";
  return kSuccess;
}

void write_all_schemas(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const FileKind& kind : file_kinds()) {
    const std::filesystem::path file = folder / (std::string(kind.name) + ".json");
    std::ofstream stream(file, std::ios::binary);
    stream << kind.schema() << std::flush;
    if (!stream) throw std::runtime_error("cannot write " + file.string());
    std::cout << file.string() << '\n';
  }
}

using Action = int (*)(const Arguments&);

CLI::Option* add_file(CLI::App& command, const std::string& name, std::string& file,
                      const std::string& help) {
  return command.add_option(name, file, help)->type_name("FILE")->required();
}

void add_kind(CLI::App& command, Arguments& arguments) {
  command
      .add_option("--kind", arguments.kind,
                  "one of " + kind_names() + "; without it the folder's name says so")
      ->type_name("KIND");
}

/// What the subcommands that read files have in common.
void finish(CLI::App& command, Command& chosen, const std::shared_ptr<Arguments>& arguments,
            Action action) {
  command.callback([&chosen, arguments, action] {
    chosen = [arguments, action] { return reporting([&] { return action(*arguments); }); };
  });
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
  auto* command =
      app.add_subcommand("check", "whether files are right: unknown keys, types, ranges");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("files", arguments->files, "the files")->type_name("FILE")->required();
  add_kind(*command, *arguments);
  finish(*command, chosen, arguments, check);
  command->footer(
      "Prints `FILE: ok`, or `FILE:line:column: key: reason`, for every file.\n"
      "Exit code: 0 all are right, 2 one is not.\n"
      "Example: scarab-config check config/*/*.yaml");
}

void add_dump(CLI::App& app, Command& chosen) {
  auto* command =
      app.add_subcommand("dump", "a file with all that it extends and every default, as YAML");
  const auto arguments = std::make_shared<Arguments>();
  arguments->files.resize(1);
  add_file(*command, "file", arguments->files[0], "the file");
  add_kind(*command, *arguments);
  finish(*command, chosen, arguments, dump);
  command->footer("Example: scarab-config dump config/plant/beetle.yaml");
}

void add_diff(CLI::App& app, Command& chosen) {
  auto* command =
      app.add_subcommand("diff", "what changes from one file to another, by their values");
  const auto arguments = std::make_shared<Arguments>();
  arguments->files.resize(2);
  add_file(*command, "a", arguments->files[0], "one file");
  add_file(*command, "b", arguments->files[1], "the other, of the same kind");
  add_kind(*command, *arguments);
  finish(*command, chosen, arguments, diff);
  command->footer(
      "Prints `key.path: value in a -> value in b`; what a file extends is part of it, comments\n"
      "are not.\n"
      "Exit code: 0 equal, 1 different, 2 nothing could be compared.\n"
      "Example: scarab-config diff config/plant/beetle.yaml my/plant.yaml --kind plant");
}

void add_match(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand(
      "match", "whether the files of one robot fit each other: joint ranges, angles");
  const auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("files", arguments->files, "at most one file of each kind, known by its folder")
      ->type_name("FILE")
      ->required()
      ->expected(2, static_cast<int>(kKindCount));
  finish(*command, chosen, arguments, match);
  command->footer(
      "Exit code: 0 they fit, 2 they do not; the first value that does not is one line.\n"
      "Example: scarab-config match config/*/beetle.yaml");
}

void add_schema(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("schema", "the JSON Schema of a kind of file, for editors");
  command->footer("Example: scarab-config schema --all config/schema");
  const auto kind = std::make_shared<std::string>();
  const auto folder = std::make_shared<std::string>();
  auto* one = command->add_option("kind", *kind, "one of " + kind_names())->type_name("KIND");
  command->add_option("--all", *folder, "write that of every kind to DIR/KIND.json")
      ->type_name("DIR")
      ->excludes(one);
  command->callback([&chosen, kind, folder] {
    if (kind->empty() && folder->empty()) throw CLI::RequiredError("KIND or --all DIR");
    chosen = [kind, folder] {
      return reporting([&] {
        if (folder->empty()) {
          std::cout << kind_named(*kind).schema();
        } else {
          write_all_schemas(*folder);
        }
        return kSuccess;
      });
    };
  });
}

}  // namespace scarab::config_tool
