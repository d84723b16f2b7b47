#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/participants.hpp"

namespace scarab::topic {

/// Who there is in a domain, without this program.
struct DomainView {
  std::map<bus::Guid, bus::DiscoveredParticipant> participants;
  std::vector<bus::DiscoveredEndpoint> endpoints;  ///< by topic

  /// What is known of the participant of an endpoint; empty if it has not been heard of.
  bus::DiscoveredParticipant participant_of(const bus::DiscoveredEndpoint& endpoint) const;
  /// The service and instance behind an endpoint (`plant/0`), or else its program (`ddsperf[312]`),
  /// or its vendor.
  std::string name_of(const bus::DiscoveredEndpoint& endpoint) const;

  std::vector<bus::DiscoveredEndpoint> of_topic(const std::string& topic) const;
  std::vector<bus::DiscoveredEndpoint> of_topic(const std::string& topic,
                                                bus::EndpointKind kind) const;
  /// The names of all topics, in order, each once.
  std::vector<std::string> topics() const;
};

/// Who made the DDS of a participant, by the first two bytes of its GUID, where the vendor follows
/// the standard's advice to put its number there; `vendor 01.42` for one not known here.
std::string vendor_of(const bus::Guid& guid);

}  // namespace scarab::topic
