#include "tests/interop/fastdds/options.hpp"

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace scarab::fastdds {

std::string Options::address() const {
  if (!tag.empty()) throw std::invalid_argument("--tag: Fast DDS has no discovery tags");
  if (!peers.empty()) throw std::invalid_argument("--peers: not in this example");
  if (interface == "lo") return "127.0.0.1";
  if (interface.find_first_not_of("0123456789.") == std::string::npos) return interface;
  throw std::invalid_argument("--interface " + interface + ": expected lo or an IPv4 address");
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--domain", options.domain, "DDS domain")->check(CLI::Range(0U, 230U));
  app.add_option("--interface", options.interface, "lo, or the IPv4 address of another interface");
  app.add_option("--instance", options.instance, "number of this instance of the service");
  app.add_option("--robot", options.robot, "robot description (YAML)");
  app.add_option("--config", options.config, "configuration file (YAML)");
  app.add_option("--run-dir", options.run_dir, "directory of this run");
  app.add_option("--expect", options.expect, "services of the stack, such as plant=1,logger=1");
  app.add_option("--tag", options.tag, "refused: Fast DDS has no discovery tags");
  app.add_option("--peers", options.peers, "refused: it finds the others by multicast");
  app.add_option("--log-level", options.log_level, "taken for the launcher's sake");
  app.add_flag("--check", options.check, "validate the configuration and exit");
  app.add_flag("--dump-config", options.dump_config, "print the resolved configuration and exit");
}

}  // namespace scarab::fastdds
