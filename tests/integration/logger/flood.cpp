#include "tests/integration/logger/flood.hpp"

#include <chrono>
#include <iostream>
#include <thread>

using namespace scarab;

/// logger_flood TAG: floods the discovery tag for a minute, or until it is killed.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: logger_flood TAG\n";
    return 2;
  }
  bus::ParticipantOptions options;
  options.tag = argv[1];
  options.self = {"flood", 0};
  bus::Participant participant(options);
  logger::test::Flood flood(participant);
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (auto next = start; next < start + std::chrono::minutes(1);
       next += std::chrono::milliseconds(1)) {
    flood.tick();
    std::this_thread::sleep_until(next);
  }
  return 0;
}
