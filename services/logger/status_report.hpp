#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "common/runtime/status_publisher.hpp"
#include "services/logger/log_series.hpp"
#include "services/logger/loss_account.hpp"

namespace scarab::logger {

/// What the recorder says of itself in scarab/service_status.
class StatusReport {
 public:
  StatusReport(bus::Participant& participant, const bus::Peer& self);

  void recorded(const RecordingState& state, const Loss& loss);
  /// Ready for a trial, whose topics are all matched.
  void ready(std::uint32_t trial);
  std::uint32_t ready_trial() const { return ready_trial_; }
  void waits_for(const std::vector<std::string>& missing);
  /// Nothing is written for the time being.
  void held_up(const std::string& obstacle);
  /// It records. `faults`: what keeps topics out of the log, or some of their samples.
  void works(const RecordingState& state, const LossAccount& losses,
             std::vector<std::string> faults);
  /// The last words. `obstacle`: why not all could be written.
  void farewell(const std::string& obstacle);

  void publish_if_due() { status_.publish_if_due(); }
  std::chrono::nanoseconds time_left() const { return status_.time_left(); }

 private:
  runtime::StatusPublisher status_;
  std::uint32_t ready_trial_ = 0;
};

}  // namespace scarab::logger
