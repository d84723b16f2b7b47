#pragma once

#include <string>
#include <vector>

#include "common/bus/discovery.hpp"

namespace scarab::topic {

/// The topics of the domain with who writes and who reads them, one line a topic; verbose: one more
/// for each endpoint with its QoS.
std::string topic_table(const std::vector<bus::DiscoveredEndpoint>& endpoints, bool verbose);

/// The names of the topics that have a writer, in order.
std::vector<std::string> written_topics(const std::vector<bus::DiscoveredEndpoint>& endpoints);

}  // namespace scarab::topic
