#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "services/plant/core/observation.hpp"

namespace scarab::plant {

/// The newest ideal observations, one a physics step. Before the first, the robot is taken to have
/// stood as it then was.
class TruthHistory {
 public:
  /// Keeps what is needed to look back `age_most_steps`.
  explicit TruthHistory(std::size_t age_most_steps) : ring_(age_most_steps + 1) {}

  void push(const Observation& truth) {
    if (seen_ == 0) std::fill(ring_.begin(), ring_.end(), truth);
    ring_[seen_++ % ring_.size()] = truth;
  }

  /// The truth of `age_steps` ago, 0 for the newest; no more than the constructor was told.
  [[nodiscard]] const Observation& at(std::size_t age_steps) const {
    return ring_[(seen_ + ring_.size() - 1 - age_steps) % ring_.size()];
  }

 private:
  std::vector<Observation> ring_;
  std::size_t seen_ = 0;
};

}  // namespace scarab::plant
