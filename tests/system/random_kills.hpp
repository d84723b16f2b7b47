#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace scarab::test {

/// A kill -9 to come.
struct Kill {
  std::string service;
  std::int64_t tick = 0;               ///< not before the trial has come to it
  std::chrono::microseconds delay{0};  ///< and then so much later
};

/// `count` kills of premotor, supervisor and logger in order of their ticks, in a trial of `ticks`
/// ticks; every fourth follows the one before at once, so that it meets services that are coming
/// up.
std::vector<Kill> random_kills(std::uint64_t seed, std::size_t count, std::int64_t ticks);

/// SCARAB_TEST_SEED, or one that differs in every run.
std::uint64_t test_seed();

}  // namespace scarab::test
