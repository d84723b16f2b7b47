#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/bus/participant.hpp"
#include "common/runtime/expectation.hpp"

namespace CLI {
class App;
}

namespace scarab::runtime {

/// Where on the bus a program stands.
struct BusOptions {
  std::uint32_t domain = 0;
  std::string tag;
  std::string interface = bus::kDefaultInterface;
  std::vector<std::string> peers;  ///< hosts to ask where the network has no multicast

  [[nodiscard]] bus::ParticipantOptions participant(const std::string& service,
                                                    std::uint32_t instance) const;
};

/// What every service takes on its command line.
struct ServiceOptions {
  BusOptions bus;
  std::uint32_t instance = 0;
  std::filesystem::path config;
  std::filesystem::path run_dir;  ///< empty: the service keeps nothing on disk
  Expectation expect;
  std::string log_level = "info";
  bool check = false;        ///< validate the configuration only
  bool dump_config = false;  ///< print the resolved configuration only
};

/// Adds --domain, --tag, --interface, --peers.
void add_bus_options(CLI::App& app, BusOptions& options);

/// Adds --expect.
void add_expect_option(CLI::App& app, Expectation& expect);

/// Adds the bus options and all else of ServiceOptions.
void add_service_options(CLI::App& app, ServiceOptions& options);

}  // namespace scarab::runtime
