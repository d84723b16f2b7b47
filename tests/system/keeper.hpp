#pragma once

#include <chrono>
#include <map>
#include <string>

#include "tests/system/stack.hpp"

namespace scarab::test {

/// Kills services of a stack and starts them anew as the launcher does: after 0.1 s, 0.2 s, 0.4 s
/// ... at most 5 s (deploy/stack.yaml).
class Keeper {
 public:
  explicit Keeper(Stack& stack) : stack_(stack) {}

  /// SIGKILL; waits until it is up again if it is down.
  void kill(const std::string& service);
  /// Starts anew what has waited long enough.
  void restart_due();
  /// The same for a while.
  void look_after(std::chrono::microseconds duration);
  /// Starts anew all that is down.
  void restart_all();
  /// How often a service has been killed.
  [[nodiscard]] unsigned kills_of(const std::string& service) const;

 private:
  using Clock = std::chrono::steady_clock;

  Stack& stack_;
  std::map<std::string, unsigned> kills_;
  std::map<std::string, Clock::time_point> due_;
};

}  // namespace scarab::test
