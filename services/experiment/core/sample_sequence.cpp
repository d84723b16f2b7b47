#include "services/experiment/core/sample_sequence.hpp"

#include <fmt/format.h>

namespace scarab::experiment {

void SampleSequence::see(std::int64_t time_ns) {
  if (time_ns <= newest_ns_) return;
  if (newest_ns_ >= 0 && period_ns_ == 0) period_ns_ = time_ns;
  const std::int64_t expected_ns = newest_ns_ < 0 ? 0 : newest_ns_ + period_ns_;
  if (time_ns != expected_ns && missed_.empty()) {
    missed_ =
        fmt::format("{} of {:.3f} s was missed: the next is of {:.3f} s", what_,
                    static_cast<double>(expected_ns) / 1e9, static_cast<double>(time_ns) / 1e9);
  }
  newest_ns_ = time_ns;
}

}  // namespace scarab::experiment
