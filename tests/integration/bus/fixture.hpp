#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "common/bus/participant.hpp"

namespace scarab::bus {

/// Options of a participant on loopback, apart from every other test process by its discovery tag.
inline ParticipantOptions test_options(const std::string& service, std::uint32_t instance = 0) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string tag = std::to_string(getpid()) + test->test_suite_name() + test->name();
  return {0, tag, "lo", {service, instance}};
}

/// Waits until `condition` holds; false after `limit`.
template <class Condition>
bool eventually(Condition&& condition, std::chrono::milliseconds limit = std::chrono::seconds(10)) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace scarab::bus
