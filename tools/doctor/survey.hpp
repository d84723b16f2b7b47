#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/participants.hpp"
#include "common/runtime/options.hpp"

namespace scarab::doctor {

/// Who there is on one domain, as seen from one interface with one discovery tag.
struct Survey {
  std::map<bus::Guid, bus::DiscoveredParticipant> participants;
  std::vector<bus::DiscoveredEndpoint> endpoints;  ///< by topic
};

/// A writer and a reader of one topic that do not meet, and why.
struct Fault {
  bus::DiscoveredEndpoint writer;
  bus::DiscoveredEndpoint reader;
  std::string policy;   ///< of the QoS, or "type name", or "type"
  std::string offered;  ///< by the writer
  std::string asked;    ///< by the reader
};

/// The faults of a survey. `type_text` tells the type behind an endpoint; it is asked only where
/// two types have one name, and may answer with an empty text for "cannot say".
std::vector<Fault> faults(
    const Survey& survey,
    const std::function<std::string(const bus::DiscoveredEndpoint&)>& type_text);

/// Looks around until nothing new is announced for a moment and `at_least` participants have been
/// seen, at most `limit`, and prints what it saw as JSON. Needs a runtime::SignalBlock made before;
/// returns the exit code.
int look(const runtime::BusOptions& options, std::chrono::milliseconds limit, std::size_t at_least);

/// The survey and its faults as one JSON document; see README.md.
std::string json(const Survey& survey, const std::vector<Fault>& faults);

}  // namespace scarab::doctor
