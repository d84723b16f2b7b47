#pragma once

#include <string>

namespace scarab::runtime {

/// What the system has granted a process that has to keep time.
struct RealTimeCare {
  bool memory_locked = false;    ///< no page of it is ever swapped out
  bool priority_raised = false;  ///< the calling thread runs before all ordinary ones (SCHED_FIFO)
  std::string memory_refusal;    ///< why memory is not locked, and what would help
  std::string priority_refusal;  ///< why the priority is not raised, and what would help
};

/// Asks the system for both. What is refused leaves everything as it was.
[[nodiscard]] RealTimeCare take_real_time_care();

}  // namespace scarab::runtime
