#include "services/logger/core/recorded_progress.hpp"

namespace scarab::logger {

void RecordedProgress::note(const SampleHeader& header) {
  if (trials_ == 0 || header.trial > trial_) {
    trial_ = header.trial;
    tick_ = header.tick;
    ++trials_;
  } else if (header.trial == trial_ && header.tick > tick_) {
    missed_ticks_ += header.tick - tick_ - 1;
    tick_ = header.tick;
  }
}

}  // namespace scarab::logger
