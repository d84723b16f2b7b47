#include "services/supervisor/core/supervisor_config.hpp"

#include <stdexcept>

namespace scarab::supervisor {

std::string refusal_of_strategy(const SupervisorConfig& config, const std::string& name) {
  if (config.strategies.count(name) != 0) return "";
  std::string names;
  for (const auto& entry : config.strategies) {
    names += (names.empty() ? "" : ", ") + entry.first;
  }
  return "unknown strategy '" + name + "'; there are: " + names;
}

const Strategy& find_strategy(const SupervisorConfig& config, const std::string& name) {
  const auto found = config.strategies.find(name);
  if (found == config.strategies.end()) {
    throw std::invalid_argument(refusal_of_strategy(config, name));
  }
  return found->second;
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
