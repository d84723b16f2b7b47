#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "common/runtime/program.hpp"
#include "common/sample/sample_filter.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/follower.hpp"
#include "tools/topic/quantity.hpp"
#include "tools/topic/sample_printer.hpp"

namespace scarab::topic {
namespace {

struct EchoOptions {
  std::string topic;
  PrintOptions print;
  std::string filter;
  std::optional<std::uint64_t> count;
  bool once = false;
  double timeout_s = 2.0;
  bool has_timeout = false;
};

/// What is made of the options once the type is known.
struct Echo {
  SamplePrinter printer;
  std::optional<sample::SampleFilter> filter;
};

Echo prepare(const sample::TypeModel& model, const EchoOptions& options) {
  std::optional<SamplePrinter> printer;
  std::optional<sample::SampleFilter> filter;
  refuse_bad_usage("--field", [&] { printer.emplace(model, options.print); });
  if (!options.filter.empty()) {
    refuse_bad_usage("--filter", [&] { filter.emplace(model, options.filter); });
  }
  return {std::move(*printer), std::move(filter)};
}

/// Ends the program when no sample has come for so long; never where no such time was given.
class Silence {
 public:
  explicit Silence(const EchoOptions& options) : options_(options) { heard(); }
  void heard() { end_ = Clock::now() + milliseconds(options_.timeout_s); }
  Clock::time_point end() const { return options_.has_timeout ? end_ : Clock::time_point::max(); }
  void check() const {
    if (!options_.has_timeout || Clock::now() < end_) return;
    throw Failure(kExitTimeout, options_.topic + ": no sample " +
                                    (options_.filter.empty() ? "" : "that matches the filter ") +
                                    "within " + seconds_text(options_.timeout_s));
  }

 private:
  const EchoOptions& options_;
  Clock::time_point end_;
};

int echo(const runtime::BusOptions& bus_options, const EchoOptions& options) {
  Session session(bus_options);
  Follower follower(session, options.topic, after(milliseconds(options.timeout_s)));
  Echo echo = prepare(follower.model(), options);
  session.output().write(echo.printer.heading());
  session.output().flush();
  Silence silence(options);
  std::uint64_t printed = 0;
  int type_changes = follower.type_changes();
  const auto wanted = [&] { return !options.count || printed < *options.count; };
  std::string text;
  while (wanted() && !session.interrupted() && !session.output().closed()) {
    follower.take(silence.end(), [&](const bus::RawSample& sample) {
      if (!wanted()) return;
      if (type_changes != follower.type_changes()) {
        type_changes = follower.type_changes();
        echo = prepare(follower.model(), options);
        session.output().write(echo.printer.heading());
      }
      if (echo.filter && !echo.filter->matches(sample.cdr)) return;
      text.clear();
      echo.printer.append(sample.cdr, text);
      session.output().write(text);
      ++printed;
      silence.heard();
    });
    session.output().flush();
    if (wanted()) silence.check();
  }
  const bool unfinished = session.interrupted() && wanted() && options.count;
  return unfinished ? runtime::kExitInterrupted : runtime::kExitSuccess;
}

}  // namespace

void add_echo(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<EchoOptions>();
  CLI::App& command = *app.add_subcommand("echo", "print the samples of a topic");
  add_topic(command, options->topic);
  command
      .add_option("--field", options->print.fields,
                  "only this part of each sample (header.tick, position_rad[3]); "
                  "may be given again")
      ->allow_extra_args(false)
      ->type_name("PATH");
  command.add_option("--filter", options->filter,
                     "only samples for which this holds, such as \"header.tick > 100 AND mode = "
                     "'MODE_HARD_PUSH'\" (also <> < <= >= BETWEEN LIKE OR NOT)");
  auto* json = command.add_flag(
      "--json", [options](std::int64_t) { options->print.format = Format::kJson; },
      "a line of JSON a sample, not YAML");
  command
      .add_flag(
          "--csv", [options](std::int64_t) { options->print.format = Format::kCsv; },
          "a table: the names of the columns, then a line a sample")
      ->excludes(json);
  command
      .add_option("--elements", options->print.elements,
                  "in a table, elements of each sequence that get columns beside its length")
      ->check(CLI::NonNegativeNumber.description(""))
      ->capture_default_str()
      ->type_name("N");
  add_count(command, options->count, "end after so many samples; else at Ctrl-C");
  command.add_flag("--once", options->once, "end after one sample, like -n 1")->excludes("--count");
  auto& timeout = command;
  add_seconds(timeout, "--timeout", options->timeout_s,
              "s to wait for a writer; if given, also for each sample");
  command.footer(
      "Samples that writers keep for late joiners come first. Writers that come later are "
      "followed.\n"
      "With one --field, each line is its value.\n"
      "Examples:\n"
      "  scarab-topic echo scarab/behaviour --once\n"
      "  scarab-topic echo scarab/robot_state --csv --field header.tick --field position_rad\n"
      "  scarab-topic echo scarab/service_status --field message --filter \"health <> "
      "'HEALTH_OK'\"\n"
      "Exit codes: 0 done, 1 failed, 2 bad usage, 3 no sample in time, 4 no such topic, 5 type\n"
      "unknown, 130 interrupted before -n samples had come.");
  command.callback([&choice, options, &command] {
    if (options->once) options->count = 1;
    options->has_timeout = command.count("--timeout") > 0;
    choice.run = [&choice, options] { return echo(choice.bus, *options); };
  });
}

}  // namespace scarab::topic
