#include "tests/system/random_kills.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>

namespace scarab::test {

std::vector<Kill> random_kills(std::uint64_t seed, std::size_t count, std::int64_t ticks) {
  constexpr std::array<const char*, 3> kServices = {"premotor", "supervisor", "logger"};
  constexpr std::size_t kAtOnce = 4;
  constexpr int kTickUs = 2000;        // a tick of lockstep, about
  constexpr int kComingUpUs = 300000;  // wait and start of a service, about
  std::mt19937_64 generator(seed);
  const auto uniform = [&generator](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
  };
  std::vector<Kill> kills(count);
  for (Kill& kill : kills) {
    kill.service = kServices.at(static_cast<std::size_t>(uniform(0, kServices.size() - 1)));
    // Not at the very end: one that follows would come too late.
    kill.tick = uniform(0, ticks * 7 / 10);
    kill.delay = std::chrono::microseconds(uniform(0, kTickUs));
  }
  std::sort(kills.begin(), kills.end(),
            [](const Kill& a, const Kill& b) { return a.tick < b.tick; });
  for (std::size_t i = kAtOnce - 1; i < count; i += kAtOnce) {
    kills[i].tick = kills[i - 1].tick;
    kills[i].delay = std::chrono::microseconds(uniform(0, kComingUpUs));
  }
  return kills;
}

std::uint64_t test_seed() {
  const char* given = std::getenv("SCARAB_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
}

}  // namespace scarab::test
