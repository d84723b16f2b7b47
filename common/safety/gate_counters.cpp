#include "common/safety/gate_counters.hpp"

namespace scarab::safety {

std::vector<std::pair<std::string, std::uint64_t>> GateCounters::named() const {
  std::vector<std::pair<std::string, std::uint64_t>> result;
  for (std::size_t i = 0; i < kOutcomeCount; ++i)
    result.emplace_back(kOutcomeNames[i], outcomes[i]);
  for (std::size_t i = 0; i < kClampCount; ++i) result.emplace_back(kClampNames[i], clamps[i]);
  result.emplace_back("safe_stops", safe_stops);
  return result;
}

}  // namespace scarab::safety
