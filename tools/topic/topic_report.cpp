#include "tools/topic/topic_report.hpp"

#include <map>
#include <utility>

#include "common/bus/known_types.hpp"
#include "common/bus/qos_text.hpp"
#include "common/config/json_object.hpp"

namespace scarab::topic {
namespace {

using bus::DiscoveredEndpoint;
using bus::EndpointFault;
using bus::EndpointKind;

std::string endpoints_json(const DomainView& view,
                           const std::vector<DiscoveredEndpoint>& endpoints) {
  std::vector<std::string> out;
  for (const auto& endpoint : endpoints) out.push_back(endpoint_json(view, endpoint));
  return config::json_list(out);
}

std::string faults_json(const DomainView& view, const std::vector<EndpointFault>& faults) {
  std::vector<std::string> out;
  for (const EndpointFault& fault : faults) {
    out.push_back(config::JsonObject()
                      .text("policy", fault.policy)
                      .text("offered", fault.offered)
                      .text("asked", fault.asked)
                      .text("writer", view.name_of(fault.writer))
                      .text("reader", view.name_of(fault.reader))
                      .str());
  }
  return config::json_list(out);
}

}  // namespace

std::string TopicReport::type() const {
  std::string out;
  for (const std::string& name : types) out += (out.empty() ? "" : " != ") + name;
  return out;
}

TopicReport topic_report(const DomainView& view, const std::string& topic,
                         const bus::TypeText& type_text) {
  TopicReport report;
  report.topic = topic;
  const auto endpoints = view.of_topic(topic);
  for (const DiscoveredEndpoint& endpoint : endpoints) {
    report.types.insert(endpoint.type);
    (endpoint.kind == EndpointKind::kWriter ? report.writers : report.readers).push_back(endpoint);
  }
  report.faults = bus::endpoint_faults(endpoints, type_text);
  return report;
}

std::vector<TopicReport> topic_reports(const DomainView& view, const bus::TypeText& type_text) {
  std::vector<TopicReport> out;
  for (const std::string& topic : view.topics()) {
    out.push_back(topic_report(view, topic, type_text));
  }
  return out;
}

std::vector<std::string> type_notes(const DomainView& view, const TopicReport& report) {
  std::map<std::string, std::string> silent;  // what follows, by name
  for (const DiscoveredEndpoint& writer : report.writers) {
    if (writer.sends_type) continue;
    const bool known = bus::find_known_type(writer.type) != nullptr;
    silent[view.name_of(writer)] = known ? "; its samples are read as Scarab's own " + writer.type
                                         : "; its samples cannot be decoded";
  }
  std::vector<std::string> out;
  for (const auto& [name, consequence] : silent) {
    out.push_back(name + " sends no type information" + consequence);
  }
  return out;
}

std::vector<std::string> fault_notes(const DomainView& view, const TopicReport& report) {
  std::vector<std::string> out;
  for (const EndpointFault& fault : report.faults) {
    const std::string reader = view.name_of(fault.reader);
    const std::string writer = view.name_of(fault.writer);
    out.push_back(reader + " gets nothing from " + writer + ": " + fault.policy + ": " +
                  fault.offered + " offered, " + fault.asked + " asked");
  }
  return out;
}

std::string names_of(const DomainView& view, const std::vector<DiscoveredEndpoint>& endpoints,
                     std::size_t most) {
  std::map<std::string, int> counts;
  for (const DiscoveredEndpoint& endpoint : endpoints) ++counts[view.name_of(endpoint)];
  if (counts.empty()) return "-";
  std::string out;
  std::size_t shown = 0;
  for (const auto& [name, count] : counts) {
    if (most != 0 && shown == most) {
      return out + " +" + std::to_string(counts.size() - shown);
    }
    out += (out.empty() ? "" : ", ") + name;
    if (count > 1) out += " (" + std::to_string(count) + ")";
    ++shown;
  }
  return out;
}

std::string endpoint_json(const DomainView& view, const DiscoveredEndpoint& endpoint) {
  const bus::DiscoveredParticipant participant = view.participant_of(endpoint);
  return config::JsonObject()
      .text("service", endpoint.peer.service.empty() ? "" : to_string(endpoint.peer))
      .text("process", participant.process)
      .number("pid", std::uint64_t{participant.pid})
      .text("host", participant.host)
      .text("vendor", vendor_of(endpoint.participant))
      .text("type", endpoint.type)
      .truth("sends_type", endpoint.sends_type)
      .text("qos", bus::qos_text(*endpoint.qos))
      .str();
}

std::string report_json(const DomainView& view, const TopicReport& report) {
  return config::JsonObject()
      .text("topic", report.topic)
      .text("type", report.type())
      .raw("writers", endpoints_json(view, report.writers))
      .raw("readers", endpoints_json(view, report.readers))
      .raw("mismatches", faults_json(view, report.faults))
      .str();
}

}  // namespace scarab::topic
