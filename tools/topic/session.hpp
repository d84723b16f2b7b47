#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/participant.hpp"
#include "common/bus/participants.hpp"
#include "common/bus/waitset.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/shutdown.hpp"
#include "tools/topic/domain_view.hpp"
#include "tools/topic/output.hpp"

namespace scarab::topic {

using Clock = std::chrono::steady_clock;

/// A participant that watches the domain until Ctrl-C. Needs a runtime::SignalBlock made before.
class Session {
 public:
  explicit Session(const runtime::BusOptions& options);

  bus::Participant& participant() { return participant_; }
  bus::Discovery& discovery() { return discovery_; }
  bus::WaitSet& waitset() { return waitset_; }
  Output& output() { return output_; }
  bool interrupted() const { return shutdown_.requested(); }

  /// Sleeps until something that the wait set knows happens, or until `end`, and takes in who has
  /// come and gone. False: `end` has come.
  bool wait(Clock::time_point end);

  /// Grows whenever an endpoint is new; by this the view is known to be worth another look.
  std::uint64_t arrivals() const { return arrivals_; }

  /// All others in the domain, as of the last wait.
  DomainView view() const;

  /// The same once nothing new has been announced for `quiet`, at most after `limit`. Throws
  /// Interrupted.
  DomainView settle(std::chrono::milliseconds limit, std::chrono::milliseconds quiet = kQuiet);

  /// The writers of a topic, as soon as there are any. Throws Failure (no such topic), saying which
  /// may be meant, when it has none at `end`, and Interrupted.
  std::vector<bus::DiscoveredEndpoint> wait_for_writers(const std::string& topic,
                                                        Clock::time_point end);
  /// The same for writers and readers alike.
  std::vector<bus::DiscoveredEndpoint> wait_for_endpoints(const std::string& topic,
                                                          Clock::time_point end);

  /// Waits until a topic has so many readers. Throws Failure (timeout) and Interrupted.
  void wait_for_readers(const std::string& topic, std::size_t count, Clock::time_point end);

  /// The type of the first of these that tells it. Throws Failure (type unknown).
  bus::TopicType type_of(const std::vector<bus::DiscoveredEndpoint>& endpoints);

 private:
  // Participants on one machine know each other within some 10 ms; of a stack of 30, within 1 s.
  static constexpr std::chrono::milliseconds kQuiet{300};

  bus::Participant participant_;
  bus::Discovery discovery_;
  bus::Participants participants_;
  bus::Guard guard_;
  runtime::Shutdown shutdown_;
  bus::WaitSet waitset_;
  Output output_;
  std::uint64_t arrivals_ = 0;
};

/// When a wait of so long from now ends.
inline Clock::time_point after(std::chrono::milliseconds patience) {
  return Clock::now() + patience;
}

}  // namespace scarab::topic
