#pragma once

#include <array>
#include <string>

#include "services/supervisor/core/mode.hpp"
#include "services/supervisor/core/supervisor_config.hpp"

namespace scarab::supervisor {

/// What a person tells the supervisor (adapter: scarab/operator).
struct OperatorWord {
  enum class Command { kAutomatic, kStrategy, kMode, kInputs };

  Command command = Command::kAutomatic;
  Mode mode = Mode::kStop;
  std::array<double, 4> inputs{};  ///< I1..I4
  std::string strategy;
  std::string reason;  ///< why, for the log; may be empty
};

/// Why the word cannot be taken (a strategy that is not configured, a mode that is none, inputs
/// that are not finite or outside of [-1, 1]); empty: it can.
std::string refusal(const OperatorWord& word, const SupervisorConfig& config);

/// The pushing or walking mode whose inputs are nearest to these: what the network makes of inputs
/// given by hand is named after it.
Mode nearest_mode(const SupervisorConfig& config, const std::array<double, 4>& inputs);

}  // namespace scarab::supervisor
