#pragma once

#include <cstdint>
#include <string>

namespace scarab::experiment {

/// Watches that no sample of a trial is missing: their times are 0, 1, 2, ... periods. The period
/// is that between the first two. A sample that comes again is none of a fault.
class SampleSequence {
 public:
  /// `what` names the samples in words, such as `world_state`.
  explicit SampleSequence(std::string what) : what_(std::move(what)) {}

  /// The next sample, of that simulated time.
  void see(std::int64_t time_ns);

  /// The first that was missed, in words; empty: none.
  [[nodiscard]] const std::string& missed() const { return missed_; }

 private:
  std::string what_;
  std::int64_t newest_ns_ = -1;
  std::int64_t period_ns_ = 0;  // 0: not known yet
  std::string missed_;
};

}  // namespace scarab::experiment
