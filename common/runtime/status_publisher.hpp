#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"

namespace scarab::runtime {

/// Publishes what this service says of itself on scarab/service_status: changes of lifecycle,
/// readiness and health at once, progress and counters at most every kProgressPeriod.
class StatusPublisher {
 public:
  static constexpr std::chrono::milliseconds kProgressPeriod{250};

  StatusPublisher(bus::Participant& participant, const bus::Peer& self);

  void set_lifecycle(scarab_Lifecycle lifecycle);
  void set_ready(std::uint32_t trial);
  /// Health and the message that explains it (cut to the topic's 255 characters); logged when it
  /// changes.
  void set_health(scarab_Health health, const std::string& message = "");
  void set_progress(const scarab_Header& header);
  void set_counter(const std::string& name, std::uint64_t value);

  /// Publishes now if something important changed, or if progress did and is due.
  void publish_if_due();
  [[nodiscard]] scarab_Health health() const { return status_.health; }
  [[nodiscard]] scarab_Lifecycle lifecycle() const { return status_.lifecycle; }

 private:
  void publish();

  std::string service_;
  scarab_ServiceStatus status_{};
  std::map<std::string, std::uint64_t> counters_;
  bus::Writer<scarab_ServiceStatus> writer_;
  bool changed_ = true;
  bool progressed_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace scarab::runtime
