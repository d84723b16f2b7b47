#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "services/logger/core/recorded_progress.hpp"

namespace scarab::logger {

/// What the recorder says of itself on scarab/service_status. Changes of lifecycle, readiness and
/// health go out at once; the tick recorded last every kReportTicks or kReportDelay, since lockstep
/// waits for it; the rest with them or every kIdlePeriod.
class RecorderStatus {
 public:
  static constexpr std::uint32_t kReportTicks = 4;
  static constexpr std::chrono::milliseconds kReportDelay{20};
  static constexpr std::chrono::milliseconds kIdlePeriod{250};

  RecorderStatus(bus::Participant& participant, const bus::Peer& self);

  void set_lifecycle(scarab_Lifecycle lifecycle);
  void set_ready(std::uint32_t trial);
  /// Logged when it changes.
  void set_health(scarab_Health health, const std::string& message = "");
  void set_recorded(const RecordedProgress& progress);
  void set_counter(const std::string& name, std::uint64_t value);

  void publish_if_due();
  /// How long publish_if_due() may wait to be called again.
  std::chrono::nanoseconds time_left() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::chrono::nanoseconds due_after() const;
  void publish();

  std::string service_;
  scarab_ServiceStatus status_{};
  std::map<std::string, std::uint64_t> counters_;
  bus::Writer<scarab_ServiceStatus> writer_;
  bool changed_ = true;
  bool counted_ = false;
  std::uint32_t reported_trial_ = 0;
  std::uint32_t reported_tick_ = 0;
  Clock::time_point last_{};
};

}  // namespace scarab::logger
