#include "tools/topic/command_options.hpp"

#include <CLI/CLI.hpp>

namespace scarab::topic {

void add_seconds(CLI::App& command, const std::string& name, double& seconds,
                 const std::string& help) {
  command.add_option(name, seconds, help)
      ->capture_default_str()
      ->check(CLI::Range(0.01, 86400.0).description(""))
      ->type_name("S");
}

void add_topic(CLI::App& command, std::string& topic) {
  command.add_option("topic", topic, "such as scarab/robot_state")->required();
}

void add_count(CLI::App& command, std::optional<std::uint64_t>& count, const std::string& help) {
  command.add_option("-n,--count", count, help)
      ->check(CLI::PositiveNumber.description(""))
      ->type_name("N");
}

}  // namespace scarab::topic
