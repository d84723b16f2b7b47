#include "tests/system/robot_bridge/robot_stack.hpp"

#include <stdexcept>

#include "tests/support/files.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

constexpr const char* kExpect = "logger=1,robot_bridge=1,supervisor=1,premotor=1";

void replace_once(std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) {
    throw std::runtime_error("the bridge's configuration has no '" + from + "'");
  }
  text.replace(at, from.size(), to);
}

}  // namespace

RobotStack::RobotStack(std::filesystem::path directory, const Options& options)
    : directory_(std::move(directory)) {
  std::filesystem::create_directories(directory_);
  const Arguments robot = {"--robot",  source_file("config/robot/beetle.yaml"),
                           "--config", bridge_file(options),
                           "--device", directory_ / "device"};
  Arguments emulator = robot;
  emulator.insert(emulator.end(), {"--plant", source_file("config/plant/beetle.yaml"), "--journal",
                                   directory_ / "journal.csv"});
  launch("emulator", emulator);
  launch("logger", {"--output", log()});
  launch("robot_bridge", robot);
  for (const std::string name : {"supervisor", "premotor"}) launch(name, shipped_files(name));
}

RobotStack::~RobotStack() {
  for (auto& [name, child] : services_) child.kill();
}

/// The shipped one with its edits. It stays in a folder beside the calibration's, which it names.
std::filesystem::path RobotStack::bridge_file(const Options& options) const {
  const auto shipped = source_file("config/robot_bridge/beetle-" + options.driver + ".yaml");
  std::string text = read_text(shipped);
  for (const auto& [from, to] : options.edits) replace_once(text, from, to);
  const auto file = directory_ / "config" / "robot_bridge" / shipped.filename();
  std::filesystem::create_directories(file.parent_path());
  std::filesystem::copy(source_file("config/calibration"), directory_ / "config" / "calibration");
  write_text(file, text);
  return file;
}

void RobotStack::launch(const std::string& name, const Arguments& files) {
  const std::string dashed = name == "robot_bridge" ? "robot-bridge" : name;
  Arguments command = command_on({}, "scarab-" + dashed);
  command.insert(command.end(), files.begin(), files.end());
  command.insert(command.end(), {"--expect", kExpect, "--run-dir", directory_});
  services_.emplace(name, ChildProcess(command, directory_ / name));
}

ChildProcess RobotStack::conduct(const Arguments& options) const {
  Arguments command = command_on({}, "scarab-experiment");
  command.insert(command.end(), {"--expect", kExpect});
  command.insert(command.end(), options.begin(), options.end());
  return {command, directory_ / "experiment"};
}

bool RobotStack::tell(const Arguments& words) const {
  Arguments command = {program("scarab-emulator"), "tell", directory_};
  command.insert(command.end(), words.begin(), words.end());
  return run(command).exit_code == 0;
}

WireJournal RobotStack::journal() const { return WireJournal(directory_ / "journal.csv"); }

bool RobotStack::stop() {
  bool clean = true;
  for (const std::string name : {"premotor", "supervisor", "robot_bridge", "logger", "emulator"}) {
    ChildProcess& child = service(name);
    if (child.running()) clean = child.stop(std::chrono::seconds(20)) == 0 && clean;
  }
  return clean;
}

std::string RobotStack::errors() const {
  std::string text;
  for (const auto& [name, child] : services_) text += "--- " + name + "\n" + child.err();
  return text;
}

}  // namespace scarab::test
