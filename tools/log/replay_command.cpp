#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/log/command_line.hpp"
#include "tools/log/commands.hpp"
#include "tools/log/replay/interview.hpp"
#include "tools/log/replay/replay.hpp"
#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

struct ReplayArguments {
  LogPaths paths;
  std::vector<std::string> topics;
  std::vector<std::string> except;
  std::string speed;
  double patience_s = 10;
  std::string against;
  ReplayOptions replay;
  InterviewOptions interview;
};

/// A year: more is a slip, and what counts ns has room for it.
constexpr double kMostSeconds = 366.0 * 86400.0;

/// Nothing: as fast as it goes.
std::optional<double> speed_of(const std::string& text) {
  if (text == "max") return std::nullopt;
  try {
    std::size_t used = 0;
    const double speed = std::stod(text, &used);
    if (used == text.size() && std::isfinite(speed) && speed > 0) return speed;
  } catch (const std::logic_error&) {
    // said below
  }
  throw std::invalid_argument("--speed " + text + ": a number above 0 is meant, or max");
}

/// `premotor`, or `premotor/1`.
void set_service(const std::string& text, InterviewOptions& options) {
  const std::size_t slash = text.find('/');
  options.service = text.substr(0, slash);
  if (slash == std::string::npos) return;
  const std::string number = text.substr(slash + 1);
  constexpr std::size_t kMostDigits = 9;
  if (number.empty() || number.size() > kMostDigits ||
      number.find_first_not_of("0123456789") != std::string::npos) {
    throw std::invalid_argument("--against " + text + ": a service is meant, such as premotor/1");
  }
  options.instance = static_cast<std::uint32_t>(std::stoul(number));
}

void check_span(const ReplayOptions& options) {
  if (std::isnan(options.from_s) || std::isnan(options.to_s.value_or(0))) {
    throw std::invalid_argument("--from, --to: a number is meant");
  }
  if (options.to_s && *options.to_s < options.from_s) {
    throw std::invalid_argument("--to " + fixed_text(*options.to_s, 3) + " is before --from " +
                                fixed_text(options.from_s, 3));
  }
}

int run(ReplayArguments& arguments) {
  ReplayOptions& replay_options = arguments.replay;
  check_span(replay_options);
  replay_options.topics = {arguments.topics.begin(), arguments.topics.end()};
  replay_options.except = {arguments.except.begin(), arguments.except.end()};
  replay_options.patience = std::chrono::duration<double>(arguments.patience_s);
  const bool interviews = !arguments.against.empty();
  const std::string usual_speed = interviews ? "max" : "1";
  replay_options.speed = speed_of(arguments.speed.empty() ? usual_speed : arguments.speed);
  if (interviews) set_service(arguments.against, arguments.interview);
  const Log log = open_logs(arguments.paths);
  const runtime::SignalBlock signals;
  if (interviews) return interview(log, replay_options, arguments.interview, std::cout);
  return replay(log, replay_options, std::cout, std::cerr);
}

void add_interview_options(CLI::App& command, ReplayArguments& arguments) {
  auto* against = command.add_option(
      "--against", arguments.against,
      "supervisor or premotor (or premotor/1): ask this service what was asked in the log, and "
      "compare its answers with the recorded ones");
  against->type_name("SERVICE");
  runtime::add_expect_option(command, arguments.interview.expect);
  command.get_option("--expect")
      ->description("whose parts to play, as the service expects them; else of all in the log")
      ->needs(against);
  add_repeatable(command, "--ignore", arguments.interview.lenience.ignored,
                 "a field in which answers may differ")
      ->needs(against);
  command
      .add_option("--tolerance", arguments.interview.lenience.tolerance,
                  "numbers in answers may differ by this much")
      ->check(CLI::NonNegativeNumber)
      ->needs(against);
  for (const char* name :
       {"--topic", "--except", "--from", "--to", "--loop", "--wait", "--restamp", "--keep-times"}) {
    command.get_option(name)->excludes(against);
  }
}

void add_replay_options(CLI::App& command, ReplayArguments& arguments) {
  ReplayOptions& options = arguments.replay;
  command.add_option("--speed", arguments.speed,
                     "times as fast as recorded, or max [default: 1; against a service: max]");
  add_repeatable(command, "--topic", arguments.topics, "only this topic");
  add_repeatable(command, "--except", arguments.except, "not this topic");
  command.add_option("--trial", options.trial, "only this trial");
  command.add_option("--from", options.from_s, "s since the log's first message")
      ->check(CLI::Range(0.0, kMostSeconds).description(""));
  command.add_option("--to", options.to_s, "the same, of the end")
      ->check(CLI::Range(0.0, kMostSeconds).description(""));
  command.add_flag("--loop", options.loop, "again and again, until Ctrl-C");
  command.add_option("--wait", options.wait_readers, "start when so many readers have matched")
      ->type_name("N");
  command.add_option("--timeout", arguments.patience_s, "s to wait for readers, and for answers")
      ->check(CLI::Range(0.01, 86400.0).description(""))
      ->capture_default_str();
  command.add_flag("--restamp", options.restamp,
                   "stamp_ns in the header of samples is the time of the replay");
  command.add_flag("--keep-times", options.keep_times,
                   "samples keep their DDS source time stamps of the recording");
  command.add_flag("--force", options.force, "also where others write these topics");
}

}  // namespace

void add_replay(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand(
      "replay", "publish a log again on DDS, or run a service against the recorded robot");
  command->footer(
      "Against a service: start it by hand, then replay; each tick follows its answer to the "
      "last.\n"
      "  scarab-supervisor --config config/supervisor/beetle.yaml --domain 7\n"
      "  scarab-log replay trial.mcap --against supervisor --domain 7\n"
      "Exit code: 0 all answers are the recorded ones, 1 one is not or none came, 2 bad usage, 130 "
      "interrupted.\n"
      "Examples:\n"
      "  scarab-log replay trial.mcap --topic scarab/world_state --speed 4 --wait 1\n"
      "  scarab-log replay trial.mcap --against premotor --tolerance 1e-9");
  auto arguments = std::make_shared<ReplayArguments>();
  add_logs(*command, arguments->paths);
  add_replay_options(*command, *arguments);
  add_interview_options(*command, *arguments);
  runtime::add_bus_options(*command, arguments->replay.bus);
  command->callback([&chosen, arguments] {
    chosen = [arguments] { return run_checked([&] { return run(*arguments); }); };
  });
}

}  // namespace scarab::log
