#include "tools/topic/meter.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "common/bus/topic_type.hpp"
#include "common/runtime/program.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/follower.hpp"
#include "tools/topic/session.hpp"
#include "tools/topic/text_table.hpp"

namespace scarab::topic {
namespace {

constexpr std::chrono::seconds kLine{1};
constexpr std::size_t kColumnWidth = 10;
constexpr std::uint64_t kLinesUnderHeading = 20;

/// Numbers that are wider than their column stand apart all the same.
std::string cell_text(const std::string& text) {
  return " " + padded(text, kColumnWidth - 1, true);
}

std::string heading_text(const Meter& meter) {
  std::string names;
  std::string units;
  for (const Meter::Column& column : meter.columns()) {
    names += cell_text(column.heading);
    units += cell_text(column.unit);
  }
  return names + "\n" + units + "\n";
}

std::string line_text(const Meter& meter, bool json) {
  if (json) return meter.json() + "\n";
  std::string out;
  for (const std::string& cell : meter.row()) out += cell_text(cell);
  return out + "\n";
}

/// On a terminal again and again, so that it never scrolls away.
bool heading_is_due(std::uint64_t line) {
  return line == 0 || (Output::is_terminal() && line % kLinesUnderHeading == 0);
}

const sample::TypeModel* model_of(const Follower& follower) {
  return follower.type().model ? &*follower.type().model : nullptr;
}

}  // namespace

void add_measure_options(CLI::App& command, MeasureOptions& options) {
  add_topic(command, options.topic);
  add_count(command, options.lines, "end after so many lines; else at Ctrl-C");
  command.add_option("--window", options.window_s, "seconds each line looks back")
      ->capture_default_str()
      ->check(CLI::Range(1U, 3600U).description(""))
      ->type_name("S");
  command.add_flag("--json", options.json, "each line as JSON");
  add_seconds(command, "--timeout", options.timeout_s, "s to wait for a writer");
}

int measure(const runtime::BusOptions& bus_options, const MeasureOptions& options, Meter& meter) {
  Session session(bus_options);
  // What comes is measured, not what was kept.
  Follower follower(session, options.topic, after(milliseconds(options.timeout_s)), {false});
  meter.begin(model_of(follower));
  const auto unfinished = [&](std::uint64_t lines) {
    return options.lines && lines < *options.lines;
  };
  for (std::uint64_t line = 0; !options.lines || line < *options.lines; ++line) {
    const auto begin = Clock::now();
    while (Clock::now() < begin + kLine) {
      if (session.interrupted()) {
        return unfinished(line) ? runtime::kExitInterrupted : runtime::kExitSuccess;
      }
      follower.take(begin + kLine, [&](const bus::RawSample& sample) { meter.add(sample); });
    }
    meter.end_second(std::chrono::duration<double>(Clock::now() - begin).count(), options.window_s);
    if (!options.json && heading_is_due(line)) session.output().write(heading_text(meter));
    session.output().write(line_text(meter, options.json));
    session.output().flush();
    if (session.output().closed()) break;
  }
  return runtime::kExitSuccess;
}

}  // namespace scarab::topic
