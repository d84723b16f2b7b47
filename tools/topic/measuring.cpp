#include <CLI/CLI.hpp>
#include <memory>

#include "tools/topic/bandwidth_meter.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/delay_meter.hpp"
#include "tools/topic/rate_meter.hpp"

namespace scarab::topic {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 done (also at Ctrl-C without -n), 1 failed, 2 bad usage, 4 no such topic, 5 "
    "type\n"
    "unknown, 130 interrupted before -n lines.";

}  // namespace

void add_hz(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<MeasureOptions>();
  CLI::App& command = *app.add_subcommand("hz", "how often, and how regularly, samples arrive");
  add_measure_options(command, *options);
  command.footer(
      std::string(
          "Intervals are between arrivals here; samples that wait together arrive at one time.\n"
          "Examples:\n"
          "  scarab-topic hz scarab/robot_state\n"
          "  scarab-topic hz scarab/robot_state -n 1 --json\n") +
      kExitCodes);
  command.callback([&choice, options] {
    choice.run = [&choice, options] {
      RateMeter meter;
      return measure(choice.bus, *options, meter);
    };
  });
}

void add_bw(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<MeasureOptions>();
  CLI::App& command = *app.add_subcommand("bw", "how many bytes arrive, and how large samples are");
  add_measure_options(command, *options);
  command.footer(
      std::string(
          "Counts serialised samples with their header of 4 bytes; RTPS, UDP and IP come on top.\n"
          "Examples:\n"
          "  scarab-topic bw scarab/world_state\n"
          "  scarab-topic bw scarab/world_state --window 1 --json\n") +
      kExitCodes);
  command.callback([&choice, options] {
    choice.run = [&choice, options] {
      BandwidthMeter meter;
      return measure(choice.bus, *options, meter);
    };
  });
}

void add_delay(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<MeasureOptions>();
  const auto field = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("delay", "how old samples are when they arrive");
  add_measure_options(command, *options);
  command
      .add_option("--field", *field,
                  "take the time from this field (ns since 1970, or sec and nanosec), not from the "
                  "source time stamp")
      ->type_name("PATH");
  command.footer(
      std::string(
          "From the writer's time stamp to the reception here, by the wall clocks of both hosts.\n"
          "header.stamp_ns of Scarab's topics is the same clock, taken before encoding.\n"
          "Examples:\n"
          "  scarab-topic delay scarab/robot_state\n"
          "  scarab-topic delay scarab/joint_command --field header.stamp_ns\n"
          "  scarab-topic delay rt/joint_states --field header.stamp\n") +
      kExitCodes);
  command.callback([&choice, options, field] {
    choice.run = [&choice, options, field] {
      DelayMeter meter(*field);
      return measure(choice.bus, *options, meter);
    };
  });
}

}  // namespace scarab::topic
