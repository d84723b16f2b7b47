#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

/// Options that several commands have.
namespace scarab::topic {

/// Seconds, as they stand on the command line, between 0.01 and a day.
void add_seconds(CLI::App& command, const std::string& name, double& seconds,
                 const std::string& help);

/// The topic a command is about.
void add_topic(CLI::App& command, std::string& topic);

/// -n, --count: a number from 1.
void add_count(CLI::App& command, std::optional<std::uint64_t>& count, const std::string& help);

inline std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000.0));
}

}  // namespace scarab::topic
