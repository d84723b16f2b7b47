#pragma once

#include <cstdint>

#include "services/logger/core/sample_header.hpp"

namespace scarab::logger {

/// How far the recording of scarab/robot_state has come: what the tick master's back-pressure goes
/// by.
class RecordedProgress {
 public:
  /// Takes in the header of the next recorded sample. Samples of an older trial and repetitions
  /// change nothing.
  void note(const SampleHeader& header);

  /// The last tick recorded, 0 and 0 before the first sample.
  std::uint32_t trial() const { return trial_; }
  std::uint32_t tick() const { return tick_; }
  /// Trials of which anything was recorded.
  std::uint32_t trials() const { return trials_; }
  /// Ticks that never came, between ones that did. The first sample may be of any tick: a recorder
  /// that is restarted in the middle of a trial goes on from there.
  std::uint64_t missed_ticks() const { return missed_ticks_; }

 private:
  std::uint32_t trial_ = 0;
  std::uint32_t tick_ = 0;
  std::uint32_t trials_ = 0;
  std::uint64_t missed_ticks_ = 0;
};

}  // namespace scarab::logger
