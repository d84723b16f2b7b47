#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace scarab::fastdds {

/// What the launcher hands to every service on its command line.
struct Options {
  std::uint32_t domain = 0;
  std::string interface = "lo";
  std::uint32_t instance = 0;
  std::string robot;
  std::string config;
  std::string run_dir;
  std::string expect;
  std::string tag;
  std::string peers;
  std::string log_level;
  bool check = false;
  bool dump_config = false;

  /// The interface's IPv4 address. Throws std::invalid_argument for what only Cyclone DDS has:
  /// discovery tags, and interfaces by another name than lo.
  [[nodiscard]] std::string address() const;
};

struct Program {
  std::string name;
  std::string description;
};

/// Reads the command line and calls `serve`. The exit code: 0 done, 2 bad usage or configuration
/// (serve throws std::invalid_argument), 1 failed otherwise; with one line of why on stderr.
int run_program(const Program& program, int argc, char** argv,
                const std::function<void(const Options&)>& serve);

}  // namespace scarab::fastdds
