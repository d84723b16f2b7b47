#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "common/runtime/program.hpp"
#include "tools/log/command_line.hpp"
#include "tools/log/commands.hpp"
#include "tools/log/mending.hpp"
#include "tools/log/progress_line.hpp"

namespace scarab::log {
namespace {

struct RecoverArguments {
  std::filesystem::path from;
  std::filesystem::path to;
};

void mend_one(const std::filesystem::path& cut, const std::optional<std::filesystem::path>& to) {
  Mending mending;
  {
    ProgressLine line("reading " + cut.string());
    mending =
        mend(cut, to, [&](std::uint64_t done, std::uint64_t total) { line.update(done, total); });
  }
  std::cout << to_string(cut, mending) << '\n';
}

/// One that cannot be mended does not keep the others from it.
int mend_all(const std::filesystem::path& directory) {
  const auto logs = cut_logs(directory);
  std::size_t mended = 0;
  for (const auto& cut : logs) {
    try {
      mend_one(cut, std::nullopt);
      ++mended;
    } catch (const mcap::Error& error) {
      std::cerr << "scarab-log: " << error.what() << '\n';
    }
  }
  std::cout << "summary: " << mended << " of " << logs.size() << " cut logs mended\n";
  return mended == logs.size() ? runtime::kExitSuccess : runtime::kExitFailure;
}

int recover(const RecoverArguments& arguments) {
  if (std::filesystem::is_directory(arguments.from)) {
    if (arguments.to.empty()) return mend_all(arguments.from);
    throw std::invalid_argument(
        "the logs of a directory are mended in place: " + arguments.to.string() + " has no use");
  }
  std::optional<std::filesystem::path> to;
  if (!arguments.to.empty()) to = arguments.to;
  mend_one(arguments.from, to);
  return runtime::kExitSuccess;
}

}  // namespace

void add_recover(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand(
      "recover", "make a whole file of a cut one: the log of a recorder that was killed");
  command->footer(
      "In place, trial.mcap.active becomes trial.mcap; it is removed once the new file is on the "
      "disk,\nunless records in it are damaged. No file is ever overwritten.\n"
      "Examples:\n"
      "  scarab-log recover trial.mcap.active\n"
      "  scarab-log recover trial.mcap.active mended.mcap\n"
      "  scarab-log recover runs        all cut logs below runs");
  auto arguments = std::make_shared<RecoverArguments>();
  command->add_option("in", arguments->from, "the cut log, or a directory with such logs below it")
      ->type_name("FILE")
      ->required()
      ->check(CLI::ExistingPath);
  command->add_option("out", arguments->to, "the new file; else in place")->type_name("FILE");
  command->callback([&chosen, arguments] {
    chosen = [arguments] { return run_checked([&] { return recover(*arguments); }); };
  });
}

}  // namespace scarab::log
