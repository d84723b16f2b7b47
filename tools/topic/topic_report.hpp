#pragma once

#include <set>
#include <string>
#include <vector>

#include "common/bus/endpoint_fault.hpp"
#include "tools/topic/domain_view.hpp"

namespace scarab::topic {

/// What there is to say of one topic.
struct TopicReport {
  std::string topic;
  std::set<std::string> types;  ///< by name; more than one is a fault
  std::vector<bus::DiscoveredEndpoint> writers;
  std::vector<bus::DiscoveredEndpoint> readers;
  std::vector<bus::EndpointFault> faults;

  /// `scarab::RobotState`, or `a::One != a::Other`.
  std::string type() const;
};

/// A report of each topic, by name. `type_text` as in bus::endpoint_faults.
std::vector<TopicReport> topic_reports(const DomainView& view, const bus::TypeText& type_text);
TopicReport topic_report(const DomainView& view, const std::string& topic,
                         const bus::TypeText& type_text);

/// A sentence each for writers that send no type information, and what follows from it.
std::vector<std::string> type_notes(const DomainView& view, const TopicReport& report);
/// A sentence each for what keeps writers and readers apart.
std::vector<std::string> fault_notes(const DomainView& view, const TopicReport& report);

/// The names of endpoints with how many of each there are: `plant/0, ddsperf[312] (2)`; `-` for
/// none. `most`: names to show, the rest as a number; 0: all.
std::string names_of(const DomainView& view, const std::vector<bus::DiscoveredEndpoint>& endpoints,
                     std::size_t most = 0);

/// Who an endpoint belongs to, and its QoS, as JSON.
std::string endpoint_json(const DomainView& view, const bus::DiscoveredEndpoint& endpoint);
std::string report_json(const DomainView& view, const TopicReport& report);

}  // namespace scarab::topic
