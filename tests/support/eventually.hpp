#pragma once

#include <chrono>
#include <thread>

namespace scarab::test {

/// Long enough for a loaded machine; only a failing test waits this long.
inline constexpr std::chrono::seconds kPatience{20};

/// Waits until `condition()` holds; false after `limit`.
template <class Condition>
bool eventually(Condition&& condition, std::chrono::milliseconds limit = kPatience) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace scarab::test
