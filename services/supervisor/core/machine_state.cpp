#include "services/supervisor/core/machine_state.hpp"

#include <algorithm>

namespace scarab::supervisor {
namespace {

/// Cuts what does not fit; always zero-terminated.
template <std::size_t Size>
void assign(std::array<char, Size>& field, const std::string& text) {
  field.fill('\0');
  std::copy_n(text.begin(), std::min(text.size(), Size - 1), field.begin());
}

}  // namespace

void enter(MachineState& machine, State next, std::uint32_t tick, const std::string& reason) {
  machine.state = next;
  machine.entered_tick = tick;
  assign(machine.reason, reason);
  machine.bs_above = 0;
  machine.beyond = 0;
}

void choose_strategy(MachineState& machine, const std::string& name) {
  assign(machine.strategy, name);
}

bool is_manual(const MachineState& machine) {
  return machine.manual.hold != Manual::Hold::kNothing;
}

std::string standing(const MachineState& machine) {
  std::string holds = "automatic: the trial's strategy";
  if (machine.strategy[0] != '\0') {
    holds = "automatic: strategy " + std::string(machine.strategy.data());
  }
  if (is_manual(machine)) holds = "manual: " + phrase(machine.manual);
  return machine.state == State::kSafeStop ? "safe stop; after it " + holds : holds;
}

}  // namespace scarab::supervisor
