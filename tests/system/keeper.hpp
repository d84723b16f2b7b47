#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "tests/system/stack.hpp"

namespace scarab::test {

/// Kills services of a stack and starts them anew as the launcher does: after 0.1 s, 0.2 s, 0.4 s
/// ... at most 5 s (deploy/stack.yaml).
class Keeper {
 public:
  explicit Keeper(Stack& stack) : stack_(stack) {}

  /// SIGKILL; waits until it is up again if it is down.
  void kill(const std::string& service, std::uint32_t instance = 0);
  /// Starts anew what has waited long enough.
  void restart_due();
  /// The same for a while.
  void look_after(std::chrono::microseconds duration);
  /// Starts anew all that is down.
  void restart_all();
  /// None waits to be started.
  [[nodiscard]] bool all_up() const { return due_.empty(); }
  /// How often a service has been killed.
  [[nodiscard]] unsigned kills_of(const std::string& service, std::uint32_t instance = 0) const;

 private:
  using Clock = std::chrono::steady_clock;

  using Process = std::pair<std::string, std::uint32_t>;

  Stack& stack_;
  std::map<Process, unsigned> kills_;
  std::map<Process, Clock::time_point> due_;
};

}  // namespace scarab::test
