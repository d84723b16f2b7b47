#pragma once

#include <string>

#include "tools/emulator/faults/effects.hpp"
#include "tools/emulator/faults/fault_text.hpp"

namespace scarab::emulator::testing {

/// What one fault does, by its words.
inline Effects suffering(const std::string& text) {
  return effects_of({std::get<Fault>(parse_fault_order(text))});
}

}  // namespace scarab::emulator::testing
