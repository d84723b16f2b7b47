#include "tools/topic/topic_table.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "common/bus/qos_text.hpp"

namespace scarab::topic {

namespace {

using bus::DiscoveredEndpoint;
using bus::EndpointKind;

struct Row {
  std::set<std::string> types;
  std::vector<const DiscoveredEndpoint*> endpoints;

  std::string peers(EndpointKind kind) const {
    std::map<std::string, int> counts;
    for (const auto* endpoint : endpoints) {
      if (endpoint->kind == kind) ++counts[to_string(endpoint->peer)];
    }
    std::string out;
    for (const auto& [name, count] : counts) {
      out += (out.empty() ? "" : ", ") + name;
      if (count > 1) out += " (" + std::to_string(count) + ")";
    }
    return out.empty() ? "-" : out;
  }
};

std::string pad(const std::string& text, std::size_t width) {
  return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

std::string join(const std::set<std::string>& parts) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : " != ") + part;
  return out;
}

std::string details(const Row& row) {
  std::string out;
  for (const auto* endpoint : row.endpoints) {
    out += endpoint->kind == EndpointKind::kWriter ? "  writer " : "  reader ";
    out += pad(to_string(endpoint->peer), 16) + " " + bus::qos_text(*endpoint->qos) + "\n";
  }
  return out;
}

}  // namespace

std::string topic_table(const std::vector<DiscoveredEndpoint>& endpoints, bool verbose) {
  std::map<std::string, Row> rows;
  for (const DiscoveredEndpoint& endpoint : endpoints) {
    rows[endpoint.topic].types.insert(endpoint.type);
    rows[endpoint.topic].endpoints.push_back(&endpoint);
  }
  std::size_t topic_width = 5;
  std::size_t type_width = 4;
  std::size_t writers_width = 7;
  for (const auto& [topic, row] : rows) {
    topic_width = std::max(topic_width, topic.size());
    type_width = std::max(type_width, join(row.types).size());
    writers_width = std::max(writers_width, row.peers(EndpointKind::kWriter).size());
  }
  const auto line = [&](const std::string& topic, const std::string& type,
                        const std::string& writers, const std::string& readers) {
    return pad(topic, topic_width) + "  " + pad(type, type_width) + "  " +
           pad(writers, writers_width) + "  " + readers + "\n";
  };
  std::string out = line("TOPIC", "TYPE", "WRITERS", "READERS");
  for (const auto& [topic, row] : rows) {
    out += line(topic, join(row.types), row.peers(EndpointKind::kWriter),
                row.peers(EndpointKind::kReader));
    if (verbose) out += details(row);
  }
  return out;
}

std::vector<std::string> written_topics(const std::vector<DiscoveredEndpoint>& endpoints) {
  std::set<std::string> names;
  for (const DiscoveredEndpoint& endpoint : endpoints) {
    if (endpoint.kind == EndpointKind::kWriter) names.insert(endpoint.topic);
  }
  return {names.begin(), names.end()};
}

}  // namespace scarab::topic
