#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scarab::test {

/// A program run by a test. It never outlives the test: the object stops it, kills it if it does
/// not stop, and the kernel kills it if the test process dies first.
class ChildProcess {
 public:
  /// Starts `command`; stdin is `input`, stdout and stderr go to `<output>.out` and `<output>.err`.
  /// Throws std::system_error if it cannot be started.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& output,
               const std::filesystem::path& input = "/dev/null");
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  [[nodiscard]] pid_t pid() const { return pid_; }
  [[nodiscard]] bool running() { return !wait(std::chrono::seconds(0)); }

  /// Sends a signal unless it has ended already.
  void signal(int number);
  /// Its exit code once it has ended, 128 + n if signal n ended it; nothing after `limit`.
  std::optional<int> wait(std::chrono::milliseconds limit);
  /// SIGTERM, then wait.
  std::optional<int> stop(std::chrono::milliseconds limit = std::chrono::seconds(10));
  /// SIGKILL, and gone when it returns.
  void kill();

  [[nodiscard]] std::string out() const;
  [[nodiscard]] std::string err() const;
  /// All it has printed: stdout, then stderr.
  [[nodiscard]] std::string output() const { return out() + err(); }

 private:
  pid_t pid_ = -1;
  std::optional<int> exit_code_;
  std::filesystem::path output_;
};

}  // namespace scarab::test
