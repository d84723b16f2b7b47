#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scarab::test {

/// A program this test has started; killed when the object goes, if it still runs.
class ChildProcess {
 public:
  /// Starts `command` (program and arguments); its stdout and stderr go to `output`.
  ChildProcess(const std::vector<std::string>& command, std::filesystem::path output);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  void signal(int number) const;
  /// Waits for the end. The exit code, or minus the signal that ended it; nothing when it still
  /// runs after `limit`.
  std::optional<int> wait(std::chrono::milliseconds limit);
  /// What it has printed.
  std::string output() const;

 private:
  std::filesystem::path output_;
  pid_t pid_ = -1;
  std::optional<int> result_;
};

}  // namespace scarab::test
