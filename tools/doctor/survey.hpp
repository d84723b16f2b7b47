#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/endpoint_fault.hpp"
#include "common/bus/participants.hpp"
#include "common/runtime/options.hpp"

namespace scarab::doctor {

/// Who there is on one domain, as seen from one interface with one discovery tag.
struct Survey {
  std::map<bus::Guid, bus::DiscoveredParticipant> participants;
  std::vector<bus::DiscoveredEndpoint> endpoints;  ///< by topic
};

/// Looks around until nothing new is announced for a moment and `at_least` participants have been
/// seen, at most `limit`, and prints what it saw as JSON. Needs a runtime::SignalBlock made before;
/// returns the exit code.
int look(const runtime::BusOptions& options, std::chrono::milliseconds limit, std::size_t at_least);

/// The survey and its faults as one JSON document; see README.md.
std::string json(const Survey& survey, const std::vector<bus::EndpointFault>& faults);

}  // namespace scarab::doctor
