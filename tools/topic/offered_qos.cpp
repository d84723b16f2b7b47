#include "tools/topic/offered_qos.hpp"

#include <algorithm>
#include <optional>

#include "common/bus/qos.hpp"
#include "common/bus/topics.hpp"

namespace scarab::topic {
namespace {

using bus::DiscoveredEndpoint;
using bus::RawQos;

RawQos usual_qos(const std::string& topic) {
  RawQos qos;
  qos.durability = DDS_DURABILITY_TRANSIENT_LOCAL;
  bus::for_each_topic([&](const auto& known) {
    if (topic == known.name) qos = bus::raw_qos_of(*bus::writer_qos(known.profile));
  });
  return qos;
}

using Duration = std::optional<std::chrono::nanoseconds>;

/// A promise in time must not be longer than what is asked for.
Duration shorter(const Duration& offered, const Duration& asked) {
  if (!offered || !asked) return offered ? offered : asked;
  return std::min(*offered, *asked);
}

/// A name that a pattern matches: two patterns do not match each other.
std::string name_matched_by(std::string pattern) {
  pattern.erase(std::remove(pattern.begin(), pattern.end(), '*'), pattern.end());
  std::replace(pattern.begin(), pattern.end(), '?', '_');
  return pattern;
}

void strengthen_for(const DiscoveredEndpoint& reader, RawQos& qos) {
  const RawQos asked = bus::raw_qos_of(*reader.qos);
  qos.reliability = std::max(qos.reliability, asked.reliability);
  qos.durability = std::max(qos.durability, asked.durability);
  qos.liveliness = std::max(qos.liveliness, asked.liveliness);
  qos.ownership = asked.ownership;
  qos.deadline = shorter(qos.deadline, asked.deadline);
  qos.liveliness_lease = shorter(qos.liveliness_lease, asked.liveliness_lease);
  qos.xcdr2 = asked.xcdr2;
  for (const std::string& partition : asked.partitions) {
    const std::string name = name_matched_by(partition);
    const auto& there = qos.partitions;
    if (std::find(there.begin(), there.end(), name) == there.end()) qos.partitions.push_back(name);
  }
}

}  // namespace

RawQos offered_qos(const std::string& topic, const std::vector<DiscoveredEndpoint>& endpoints) {
  const auto writer = std::find_if(endpoints.begin(), endpoints.end(), [](const auto& endpoint) {
    return endpoint.kind == bus::EndpointKind::kWriter;
  });
  RawQos qos = writer == endpoints.end() ? usual_qos(topic) : bus::raw_qos_of(*writer->qos);
  qos.history_depth = usual_qos(topic).history_depth;  // writers do not announce theirs
  bool default_partition = qos.partitions.empty() && writer != endpoints.end();
  for (const DiscoveredEndpoint& endpoint : endpoints) {
    if (endpoint.kind != bus::EndpointKind::kReader) continue;
    strengthen_for(endpoint, qos);
    default_partition = default_partition || bus::raw_qos_of(*endpoint.qos).partitions.empty();
  }
  // Beside named partitions, the default one has to be named too.
  if (default_partition && !qos.partitions.empty()) qos.partitions.emplace_back();
  return qos;
}

}  // namespace scarab::topic
