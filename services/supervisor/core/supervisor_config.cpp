#include "services/supervisor/core/supervisor_config.hpp"

#include <stdexcept>

namespace scarab::supervisor {

const Strategy& find_strategy(const SupervisorConfig& config, const std::string& name) {
  const auto found = config.strategies.find(name);
  if (found != config.strategies.end()) {
    return found->second;
  }
  std::string names;
  for (const auto& entry : config.strategies) {
    names += (names.empty() ? "" : ", ") + entry.first;
  }
  throw std::invalid_argument("unknown strategy '" + name + "'; there are: " + names);
}

std::array<double, 4> inputs_of(const SupervisorConfig& config, Mode mode) {
  switch (mode) {
    case Mode::kStop:
      return config.inputs.stop;
    case Mode::kForward:
      return config.inputs.forward;
    case Mode::kBackward:
      return config.inputs.backward;
    case Mode::kSoftPush:
      return config.inputs.soft_push;
    case Mode::kBoxing:
      return config.inputs.boxing;
    case Mode::kStationary:
      return config.inputs.stationary;
    case Mode::kHardPush:
      return config.inputs.hard_push;
  }
  throw std::invalid_argument("no such mode");
}

}  // namespace scarab::supervisor
