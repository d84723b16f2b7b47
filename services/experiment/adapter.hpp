#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "services/experiment/core/heading.hpp"
#include "services/experiment/core/outcome.hpp"
#include "services/experiment/core/sample_sequence.hpp"
#include "services/experiment/core/trial_line.hpp"

namespace scarab::experiment {

/// The trial of a line as number `number` of the run; header.stamp_ns is the caller's.
scarab_Trial to_trial(const TrialLine& line, std::uint32_t number);

/// Whose word counts on how a trial stands.
enum class Judge {
  kReferee,    ///< the verdict in world_state, which comes with the ticks: a simulated trial
  kTickMaster  ///< the phase in robot_state; world_state, if any, runs on a clock of its own
};

/// Follows one trial from the topics: collects the changes of behaviour, measures, the verdict. It
/// needs every sample, in the order of each topic; how the topics interleave does not matter.
class TrialWatch {
 public:
  explicit TrialWatch(const scarab_Trial& trial, Judge judge = Judge::kReferee);

  void see(const scarab_Behaviour& behaviour);
  void see(const scarab_WorldState& world);
  /// Not needed where the referee judges.
  void see(const scarab_RobotState& state);
  /// What the tick master says of how it ended; the referee's words come before it.
  void explain(const std::string& reason);
  /// Ends the trial from here: it cannot be judged.
  void fail(const std::string& reason);
  /// Something of the trial was not seen.
  void miss(const std::string& what);

  /// Its end is known, but not why.
  [[nodiscard]] bool wants_reason() const { return outcome_.judged && outcome_.reason.empty(); }
  /// Its first tick has come.
  [[nodiscard]] bool began() const { return started_.has_value(); }
  [[nodiscard]] bool ended() const { return ended_; }
  /// The last answer of the chain has come, too: there is nothing more to see.
  [[nodiscard]] bool complete() const;
  [[nodiscard]] const Outcome& outcome() const { return outcome_; }
  [[nodiscard]] std::uint32_t last_tick() const { return last_tick_; }

 private:
  void watch_for_gap(const scarab_Behaviour& behaviour);
  void progress(const scarab_Header& header);
  void measure(const scarab_WorldState& world);
  void end(bool success, const std::string& reason);

  struct Place {
    std::array<double, 3> trunk_m{};
    double object_y_m = 0;
  };

  Judge judge_;
  Outcome outcome_;
  SampleSequence worlds_{"world_state"};
  std::optional<Place> start_;
  Turn turn_;
  std::optional<std::chrono::steady_clock::time_point> started_;
  std::optional<scarab_BehaviourState> state_;
  std::int64_t behaviour_tick_ = -1;  // newest seen
  std::uint32_t last_tick_ = 0;
  bool ended_ = false;
  bool measured_ = false;        // up to the referee's verdict
  std::optional<bool> referee_;  // whether its verdict is success
  std::string referee_reason_;
};

}  // namespace scarab::experiment
