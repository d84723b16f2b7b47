#include "common/runtime/options.hpp"

#include <CLI/CLI.hpp>

namespace scarab::runtime {
namespace {

/// An address or the name of a host; what it is exactly is for the bus to find out.
const CLI::Validator kPeer(
    [](const std::string& text) {
      const bool fits = !text.empty() && text.find_first_of(" \t<>&\"'") == std::string::npos;
      return fits ? std::string() : "'" + text + "' is no address of a host";
    },
    "");

}  // namespace

bus::ParticipantOptions BusOptions::participant(const std::string& service,
                                                std::uint32_t instance) const {
  bus::ParticipantOptions options;
  options.domain = domain;
  options.tag = tag;
  options.interface = interface;
  options.peers = peers;
  options.self = {service, instance};
  return options;
}

void add_bus_options(CLI::App& app, BusOptions& options) {
  app.add_option("--domain", options.domain, "DDS domain")
      ->check(CLI::Range(0U, 230U))
      ->capture_default_str();
  app.add_option("--tag", options.tag, "discovery tag: only participants of the same tag meet");
  app.add_option("--interface", options.interface, "network interface, by name or address")
      ->capture_default_str();
  app.add_option("--peers", options.peers,
                 "addresses of the other hosts, where the network has no multicast")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(kPeer)
      ->type_name("ADDRESS,...");
}

void add_expect_option(CLI::App& app, Expectation& expect) {
  app.add_option_function<std::string>(
         "--expect",
         [&expect](const std::string& text) {
           try {
             expect = parse_expectation(text);
           } catch (const std::invalid_argument& error) {
             throw CLI::ValidationError("--expect", error.what());
           }
         },
         "services of the stack, such as plant=1,supervisor=1,premotor=1,logger=1")
      ->type_name("NAME=COUNT,...");
}

void add_service_options(CLI::App& app, ServiceOptions& options) {
  add_bus_options(app, options.bus);
  add_expect_option(app, options.expect);
  app.add_option("--instance", options.instance, "number of this instance of the service")
      ->check(CLI::Range(0U, 15U))
      ->capture_default_str();
  app.add_option("--config", options.config, "configuration file (YAML)");
  app.add_option("--run-dir", options.run_dir, "directory of this run");
  app.add_option("--log-level", options.log_level, "least severe log level shown")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error"}))
      ->capture_default_str();
  app.add_flag("--check", options.check, "validate the configuration and exit");
  app.add_flag("--dump-config", options.dump_config, "print the resolved configuration and exit");
}

}  // namespace scarab::runtime
