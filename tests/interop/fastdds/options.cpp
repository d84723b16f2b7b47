#include "tests/interop/fastdds/options.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

namespace scarab::fastdds {
namespace {

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

}  // namespace

std::string Options::address() const {
  if (!tag.empty()) throw std::invalid_argument("--tag: Fast DDS has no discovery tags");
  if (!peers.empty()) throw std::invalid_argument("--peers: not in this example");
  if (interface == "lo") return "127.0.0.1";
  if (interface.find_first_not_of("0123456789.") == std::string::npos) return interface;
  throw std::invalid_argument("--interface " + interface + ": expected lo or an IPv4 address");
}

int run_program(const Program& program, int argc, char** argv,
                const std::function<void(const Options&)>& serve) {
  CLI::App app{program.description, program.name};
  Options options;
  add_options(app, options);
  int failed = 1;
  try {
    app.parse(argc, argv);
    serve(options);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    failed = 2;
    std::cerr << program.name << ": " << error.what() << '\n';
  } catch (const std::exception& error) {
    std::cerr << program.name << ": " << error.what() << '\n';
  }
  return failed;
}

}  // namespace scarab::fastdds
