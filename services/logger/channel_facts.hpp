#pragma once

#include <vector>

#include "common/bus/discovery.hpp"
#include "services/logger/sample_batch.hpp"

namespace scarab::logger {

/// What the channel of a topic is to say: its type with IDL and, so that a program that knows no
/// type can publish the topic again, who writes it, their QoS (`qos.<word>`, of the first) and the
/// type's bytes (`type_information`, `type_mapping`, base64). `writers`: those known of the topic,
/// at least one.
ChannelSpec describe_channel(const std::vector<bus::DiscoveredEndpoint>& writers,
                             const bus::TopicType& type);

}  // namespace scarab::logger
