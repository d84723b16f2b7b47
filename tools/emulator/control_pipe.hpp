#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scarab::emulator {

/// A named pipe (FIFO) into which anybody may write lines.
class ControlPipe {
 public:
  /// Without a path nobody can. One that a dead emulator has left is taken over. Throws
  /// std::runtime_error, naming the path, if it cannot be made, is something else, or is read by
  /// somebody already.
  explicit ControlPipe(std::filesystem::path path);
  ~ControlPipe();
  ControlPipe(const ControlPipe&) = delete;
  ControlPipe& operator=(const ControlPipe&) = delete;

  /// What ppoll() waits on; -1 without a path.
  [[nodiscard]] int fd() const { return fd_; }
  /// The whole lines that have come.
  [[nodiscard]] std::vector<std::string> read();

 private:
  std::filesystem::path path_;
  int fd_ = -1;
  std::string begun_;
};

}  // namespace scarab::emulator
