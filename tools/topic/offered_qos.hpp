#pragma once

#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/raw_qos.hpp"

namespace scarab::topic {

/// The QoS to publish a topic with: that of the writers there are, else the profile of one of the
/// project's own topics, else reliable and transient-local; made to match every reader there is, as
/// far as one writer can.
bus::RawQos offered_qos(const std::string& topic,
                        const std::vector<bus::DiscoveredEndpoint>& endpoints);

}  // namespace scarab::topic
