#pragma once

#include <string>
#include <string_view>

#include "tools/emulator/faults/fault.hpp"

namespace scarab::emulator {

/// Reads a line such as `stuck TR0 at 3 for 2`:
///
///     lose P | flip P | stuck JOINT | silent JOINT|imu|board | late S | unplug | hot JOINT C
///     | current JOINT A | tilt RAD | pose JOINT RAD     [at S] [for S]
///     clear
///
/// Throws std::invalid_argument with one sentence that says what is wrong with it.
[[nodiscard]] FaultOrder parse_fault_order(std::string_view line);

/// The line that parse_fault_order() reads back to the same fault.
[[nodiscard]] std::string to_text(const Fault& fault);

/// One line for each word there is, for a help text.
[[nodiscard]] std::string fault_words_help();

}  // namespace scarab::emulator
