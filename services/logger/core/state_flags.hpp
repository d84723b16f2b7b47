#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace scarab::logger {

/// What a sample of scarab/robot_state says of its trial, read from its raw CDR bytes.
struct StateFlags {
  bool over = false;       ///< the goal was judged: this is the trial's last tick
  bool real_time = false;  ///< the tick master waits for nobody
};

/// Of bytes with encapsulation header, of either byte order. Nothing when they are too few or not
/// plain CDR.
std::optional<StateFlags> read_state_flags(const std::uint8_t* cdr, std::size_t size);

}  // namespace scarab::logger
