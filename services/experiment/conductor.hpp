#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/shutdown.hpp"
#include "common/runtime/status_board.hpp"
#include "services/experiment/adapter.hpp"
#include "services/experiment/fault_file.hpp"
#include "services/experiment/interrupted.hpp"

namespace scarab::experiment {

/// The stack did not become ready in time; says whom it waited for.
class NotReady : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs trials on the stack that is up: tells scarab/trial and watches what comes of it.
class Conductor {
 public:
  /// Called now and then during waits and trials, for the screen.
  struct Listener {
    std::function<void(const std::string&)> waiting;  ///< for whom
    std::function<void(const BehaviourChange&)> changed;
    std::function<void(const Progress&)> progress;
  };

  Conductor(bus::Participant& participant, const runtime::Expectation& expect, Listener listener,
            FaultFile fault);

  /// Until every expected service is up and matched. Throws NotReady after `limit` or at a fault,
  /// Interrupted.
  void await_stack(std::chrono::seconds limit);
  /// The first trial number that nobody in the stack has seen.
  [[nodiscard]] std::uint32_t next_trial() const;
  /// Runs one trial to its end and to its last tick in the log. A fault ends it, with no success
  /// and no judgement. Throws Interrupted.
  Outcome run(scarab_Trial trial, std::chrono::seconds silence_limit);
  /// No further trial can run on this stack.
  [[nodiscard]] bool at_fault() const { return fault_.reason().has_value(); }
  /// SIGINT or SIGTERM has come.
  [[nodiscard]] bool interrupted() const { return shutdown_.requested(); }

 private:
  void wait(std::chrono::milliseconds timeout);
  void show_changes(const Outcome& outcome, std::size_t& shown) const;
  void watch_for_absence(TrialWatch& watch);
  void watch_for_trouble(TrialWatch& watch, std::chrono::seconds silence_limit);
  [[nodiscard]] bool left_over(const runtime::ServiceReport& report) const;
  [[nodiscard]] std::optional<std::string> fault() const;
  [[nodiscard]] std::optional<std::string> fault_said(bool by_logger) const;
  [[nodiscard]] bool recorded(const TrialWatch& watch) const;
  [[nodiscard]] bool is_homing(const TrialWatch& watch) const;
  void await_record(TrialWatch& watch);
  void await_reason(TrialWatch& watch);

  runtime::Expectation expect_;
  std::optional<bus::Peer> tick_master_;  // the one that is expected
  Listener listener_;
  FaultFile fault_;
  runtime::PeerCheck peers_;
  bus::Guard guard_;
  bus::WaitSet wait_set_;
  bus::Writer<scarab_Trial> trials_;
  bus::Reader<scarab_Behaviour> behaviours_;
  bus::Reader<scarab_WorldState> worlds_;
  std::optional<bus::Reader<scarab_RobotState>> states_;  // where the tick master judges
  runtime::StatusBoard board_;
  runtime::Shutdown shutdown_;
  TrialWatch* watch_ = nullptr;
  std::chrono::steady_clock::time_point heard_{};  // from the running trial
  std::chrono::steady_clock::time_point told_{};   // the running trial was
  // The tick master, on the board, since.
  std::optional<std::chrono::steady_clock::time_point> master_missed_;
  std::int64_t told_ns_ = 0;  // as the trial's stamp
  bool master_gone_ = false;
};

}  // namespace scarab::experiment
