#pragma once

#include <chrono>
#include <string>

#include "tests/interop/fastdds/writer.hpp"

namespace scarab::fastdds {

/// What this service says of itself on scarab/service_status: changes at once, progress at most
/// four times a second, and twice a second whatever happens.
class Status {
 public:
  explicit Status(Node& node);

  void set_lifecycle(Lifecycle lifecycle);
  /// The trial it is ready for; 0: none.
  void set_ready(std::uint32_t trial);
  /// The message is cut to the topic's 255 characters.
  void set_health(Health health, const std::string& message = "");
  /// The last trial and tick it has seen.
  void set_progress(const Header& header);
  /// A recorder's progress; lockstep waits for it.
  void set_recorded(std::uint32_t trial, std::uint32_t tick);

  void publish_if_due();

 private:
  ServiceStatus status_;
  Writer<ServiceStatusPubSubType> writer_;
  bool changed_ = true;
  bool progressed_ = false;
  std::uint32_t reported_tick_ = 0;
  std::chrono::steady_clock::time_point last_{};
};

/// The wall clock, ns since the Unix epoch.
std::int64_t now_ns();

}  // namespace scarab::fastdds
