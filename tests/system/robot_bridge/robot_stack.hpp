#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tests/support/programs.hpp"
#include "tests/system/robot_bridge/wire_journal.hpp"

namespace scarab::test {

/// A stack whose robot is at the other end of a wire: bridge, emulator and the other services, up
/// as long as the object, on the running test's tag.
class RobotStack {
 public:
  struct Options {
    std::string driver = "dynamixel";
    /// Texts of the shipped bridge configuration, and what stands in their place.
    std::map<std::string, std::string> edits = {};
  };

  /// Starts all; `directory` is made and becomes their run directory. Throws std::runtime_error for
  /// an edit that finds nothing.
  explicit RobotStack(std::filesystem::path directory, const Options& options);
  explicit RobotStack(const std::filesystem::path& directory) : RobotStack(directory, Options{}) {}

  /// Kills what lives: how it ends is of no interest to a test that has not called stop().
  ~RobotStack();
  RobotStack(const RobotStack&) = delete;
  RobotStack& operator=(const RobotStack&) = delete;

  ChildProcess& service(const std::string& name) { return services_.at(name); }
  /// Starts the experiment service with these options.
  [[nodiscard]] ChildProcess conduct(const Arguments& options) const;
  /// Has the emulator misbehave: words of its control pipe. True if they were taken.
  [[nodiscard]] bool tell(const Arguments& words) const;
  /// What has happened so far at the robot's end of the wire.
  [[nodiscard]] WireJournal journal() const;
  /// Ends all that live, logger and emulator last; true if all ended with exit code 0.
  bool stop();

  /// The closed log, once the stack is stopped.
  [[nodiscard]] std::filesystem::path log() const { return directory_ / "trial.mcap"; }
  /// What all services have said on stderr.
  [[nodiscard]] std::string errors() const;

 private:
  void launch(const std::string& name, const Arguments& files);
  [[nodiscard]] std::filesystem::path bridge_file(const Options& options) const;

  std::filesystem::path directory_;
  std::map<std::string, ChildProcess> services_;
};

}  // namespace scarab::test
