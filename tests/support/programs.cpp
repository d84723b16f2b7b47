#include "tests/support/programs.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/support/files.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

void append(Arguments& arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
}

}  // namespace

std::filesystem::path source_file(const std::string& relative) {
  return std::filesystem::path(SCARAB_SOURCE_DIR) / relative;
}

std::string program(const std::string& name) { return std::string(SCARAB_BIN_DIR) + "/" + name; }

Arguments shipped_files(const std::string& service, const std::string& robot) {
  const auto file = [&](const std::string& folder) {
    return source_file("config/" + folder + "/" + robot + ".yaml");
  };
  Arguments arguments;
  const bool of_bridge = service == "robot_bridge" || service == "emulator";
  if (service == "plant" || service == "premotor" || of_bridge) {
    append(arguments, {"--robot", file("robot")});
  }
  if (of_bridge) {
    append(arguments,
           {"--config", source_file("config/robot_bridge/" + robot + "-dynamixel.yaml")});
  }
  if (service == "emulator") append(arguments, {"--plant", file("plant")});
  if (service == "plant" || service == "premotor" || service == "supervisor") {
    append(arguments, {"--config", file(service)});
  }
  return arguments;
}

std::string program_of(std::string service) {
  std::replace(service.begin(), service.end(), '_', '-');
  return "scarab-" + service;
}

Arguments command_on(const Host& host, const std::string& name) {
  Arguments command = host.enter;
  command.push_back(program(name));
  if (!host.has_own_network) append(command, {"--tag", test_tag()});
  append(command, host.bus);
  return command;
}

ChildProcess start(const ServiceLaunch& launch) {
  Arguments command = command_on(launch.host, program_of(launch.name));
  append(command, shipped_files(launch.name, launch.robot));
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
