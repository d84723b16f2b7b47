#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/child_process.hpp"

namespace scarab::test {

using Arguments = std::vector<std::string>;

/// A file of the source tree, such as `config/robot/beetle.yaml`.
std::filesystem::path source_file(const std::string& relative);
/// The path of a program of this build, such as `scarab-plant`.
std::string program(const std::string& name);

/// The files of a service as the project ships them for a robot: --robot and --config. Of the
/// robot bridge, and of the emulator at its wire, those of the driver that stack.yaml names.
Arguments shipped_files(const std::string& service, const std::string& robot = "beetle");

/// The program of a service, such as scarab-robot-bridge of robot_bridge.
std::string program_of(std::string service);

/// Where a program runs, and how it joins the bus there; this host, unless said.
struct Host {
  Arguments enter;               ///< what its command line begins with
  Arguments bus;                 ///< such as --interface eth1
  bool has_own_network = false;  ///< needs no tag to be apart from others
};

/// How a program of this build is started on a host: its name, the test's tag, the host's bus.
Arguments command_on(const Host& host, const std::string& name);

/// How a service of the running test is started.
struct ServiceLaunch {
  std::string name;    ///< plant, supervisor, premotor, logger
  std::string expect;  ///< such as plant=1,supervisor=1
  std::filesystem::path run_dir;
  std::uint32_t instance = 0;
  Arguments more;
  std::string robot = "beetle";  ///< whose files
  Host host = {};
};

/// Starts it with the shipped files on the test's tag; its output goes to `<run_dir>/<name>-<i>.*`.
ChildProcess start(const ServiceLaunch& launch);

/// Runs a program to its end; throws std::runtime_error if it takes longer than `limit`.
struct Finished {
  int exit_code = -1;
  std::string out;
  std::string err;
};
Finished run(const Arguments& command, std::chrono::milliseconds limit = std::chrono::seconds(30));

}  // namespace scarab::test
