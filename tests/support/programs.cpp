#include "tests/support/programs.hpp"

#include <map>
#include <stdexcept>

#include "tests/support/files.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

const std::map<std::string, std::string>& shipped_configs() {
  static const std::map<std::string, std::string> files = {
      {"plant", "config/plant/beetle.yaml"},
      {"supervisor", "config/supervisor/beetle.yaml"},
      {"premotor", "config/premotor/beetle.yaml"}};
  return files;
}

void append(Arguments& arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
}

}  // namespace

std::filesystem::path source_file(const std::string& relative) {
  return std::filesystem::path(SCARAB_SOURCE_DIR) / relative;
}

std::string program(const std::string& name) { return std::string(SCARAB_BIN_DIR) + "/" + name; }

Arguments shipped_files(const std::string& service) {
  Arguments arguments;
  if (service == "plant" || service == "premotor") {
    append(arguments, {"--robot", source_file("config/robot/beetle.yaml")});
  }
  const auto config = shipped_configs().find(service);
  if (config != shipped_configs().end()) {
    append(arguments, {"--config", source_file(config->second)});
  }
  return arguments;
}

ChildProcess start(const ServiceLaunch& launch) {
  Arguments command = {program("scarab-" + launch.name), "--tag", test_tag()};
  append(command, shipped_files(launch.name));
  append(command, {"--instance", std::to_string(launch.instance)});
  if (!launch.expect.empty()) append(command, {"--expect", launch.expect});
  append(command, {"--run-dir", launch.run_dir});
  append(command, launch.more);
  return {command, launch.run_dir / (launch.name + "-" + std::to_string(launch.instance))};
}

Finished run(const Arguments& command, std::chrono::milliseconds limit) {
  const TemporaryDirectory directory;
  ChildProcess child(command, directory / "run");
  const auto code = child.wait(limit);
  if (!code) throw std::runtime_error(command.front() + " takes too long: " + child.err());
  return {*code, child.out(), child.err()};
}

}  // namespace scarab::test
