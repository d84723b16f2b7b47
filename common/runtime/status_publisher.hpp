#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/histogram.hpp"

namespace scarab::runtime {

/// Counter with the stamp (header.stamp_ns) of the last scarab/operator command carried out.
inline constexpr const char* kOperatorStamp = "operator_stamp_ns";

/// Publishes what this service says of itself on scarab/service_status: changes of lifecycle,
/// readiness and health at once, the tick recorded last every kRecordedTicks or kRecordedPeriod
/// (lockstep waits for it), progress and counters at most every kProgressPeriod.
class StatusPublisher {
 public:
  static constexpr std::chrono::milliseconds kProgressPeriod{250};
  /// Who has heard nothing for longer than a lease, because it had no CPU, takes us for gone, and
  /// goes on doing so until our next word: there is one even where nothing has changed.
  static constexpr std::chrono::milliseconds kRepeatPeriod{500};
  static constexpr std::uint32_t kRecordedTicks = 24;
  static constexpr std::chrono::milliseconds kRecordedPeriod{20};

  StatusPublisher(bus::Participant& participant, const bus::Peer& self);

  void set_lifecycle(scarab_Lifecycle lifecycle);
  void set_ready(std::uint32_t trial);
  /// Health and the message that explains it (cut to the topic's 255 characters); logged when it
  /// changes.
  void set_health(scarab_Health health, const std::string& message = "");
  void set_progress(const scarab_Header& header);
  /// A recorder's progress: robot_state is recorded up to this tick.
  void set_recorded(std::uint32_t trial, std::uint32_t tick);
  void set_counter(const std::string& name, std::uint64_t value);
  void set_histogram(const std::string& name, const Histogram& histogram);

  /// Publishes now if something important changed, if progress did and is due, or if it is time to
  /// be heard again.
  void publish_if_due();
  /// How long publish_if_due() may wait to be called again.
  [[nodiscard]] std::chrono::nanoseconds time_left() const;
  [[nodiscard]] scarab_Health health() const { return status_.health; }
  [[nodiscard]] const std::string& message() const { return message_; }
  [[nodiscard]] scarab_Lifecycle lifecycle() const { return status_.lifecycle; }

 private:
  [[nodiscard]] std::chrono::nanoseconds due_after() const;
  void publish();

  std::string service_;
  std::string message_;  // uncut
  scarab_ServiceStatus status_{};
  std::map<std::string, std::uint64_t> counters_;
  std::map<std::string, Histogram> histograms_;
  bus::Writer<scarab_ServiceStatus> writer_;
  bool changed_ = true;
  bool progressed_ = false;
  std::uint32_t reported_trial_ = 0;
  std::uint32_t reported_tick_ = 0;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace scarab::runtime
