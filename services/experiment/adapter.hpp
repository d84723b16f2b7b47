#pragma once

#include <chrono>
#include <optional>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "services/experiment/core/outcome.hpp"

namespace scarab::experiment {

/// Follows one trial from the topics: collects the changes of behaviour and the verdict.
class TrialWatch {
 public:
  explicit TrialWatch(const scarab_Trial& trial);

  void see(const scarab_Behaviour& behaviour);
  void see(const scarab_WorldState& world);
  /// Ends the trial from here: it cannot be judged.
  void fail(const std::string& reason);

  [[nodiscard]] bool ended() const { return ended_; }
  [[nodiscard]] const Outcome& outcome() const { return outcome_; }
  [[nodiscard]] std::uint32_t last_tick() const { return last_tick_; }

 private:
  Outcome outcome_;
  std::optional<std::chrono::steady_clock::time_point> started_;
  std::optional<scarab_BehaviourState> state_;
  std::uint32_t last_tick_ = 0;
  bool ended_ = false;
};

}  // namespace scarab::experiment
