#include "services/supervisor/core/operator_word.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

namespace scarab::supervisor {
namespace {

std::string figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

std::string refusal_of_inputs(const std::array<double, 4>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double value = inputs[i];
    if (std::isfinite(value) && std::abs(value) <= 1) continue;
    return "I" + std::to_string(i + 1) + " is " + figure(value) + ", not in [-1, 1]";
  }
  return "";
}

}  // namespace

std::string refusal(const OperatorWord& word, const SupervisorConfig& config) {
  switch (word.command) {
    case OperatorWord::Command::kAutomatic:
      return "";
    case OperatorWord::Command::kStrategy:
      return refusal_of_strategy(config, word.strategy);
    case OperatorWord::Command::kMode:
      return static_cast<std::size_t>(word.mode) < kModeNames.size() ? "" : "no such mode";
    case OperatorWord::Command::kInputs:
      return refusal_of_inputs(word.inputs);
  }
  return "no such command";
}

Mode nearest_mode(const SupervisorConfig& config, const std::array<double, 4>& inputs) {
  Mode nearest = Mode::kBackward;
  double least = std::numeric_limits<double>::infinity();
  for (const Mode mode :
       {Mode::kForward, Mode::kBackward, Mode::kSoftPush, Mode::kBoxing, Mode::kHardPush}) {
    double squares = 0;
    const auto of_mode = inputs_of(config, mode);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      squares += (inputs[i] - of_mode[i]) * (inputs[i] - of_mode[i]);
    }
    if (squares < least) {
      least = squares;
      nearest = mode;
    }
  }
  return nearest;
}

}  // namespace scarab::supervisor
