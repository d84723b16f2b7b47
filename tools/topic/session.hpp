#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/participant.hpp"
#include "common/bus/waitset.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/shutdown.hpp"

namespace scarab::topic {

/// A participant that watches the domain until Ctrl-C. Needs a runtime::SignalBlock made before.
class Session {
 public:
  explicit Session(const runtime::BusOptions& options);

  bus::Participant& participant() { return participant_; }
  bus::Discovery& discovery() { return discovery_; }
  bus::WaitSet& waitset() { return waitset_; }
  bool interrupted() const { return shutdown_.requested(); }

  /// The endpoints of all others, once nothing new has been announced for a moment; at most after
  /// `limit`.
  std::vector<bus::DiscoveredEndpoint> settle(std::chrono::milliseconds limit);

  /// The writers of a topic, as soon as there are any; none when interrupted. Throws bus::Error
  /// saying which topics there are when it has no writer after `limit`.
  std::vector<bus::DiscoveredEndpoint> wait_for_writers(const std::string& topic,
                                                        std::chrono::milliseconds limit);

 private:
  std::vector<bus::DiscoveredEndpoint> others() const;

  bus::Participant participant_;
  bus::Discovery discovery_;
  bus::Guard guard_;
  runtime::Shutdown shutdown_;
  bus::WaitSet waitset_;
};

}  // namespace scarab::topic
