#pragma once

#include <cstdint>
#include <string>

#include "tests/interop/fastdds/peer.hpp"

namespace CLI {
class App;
}

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

void add_options(CLI::App& app, Options& options);

}  // namespace scarab::fastdds
