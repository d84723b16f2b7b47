#include "tools/topic/domain_view.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace scarab::topic {

using bus::DiscoveredEndpoint;

bus::DiscoveredParticipant DomainView::participant_of(const DiscoveredEndpoint& endpoint) const {
  const auto found = participants.find(endpoint.participant);
  return found == participants.end() ? bus::DiscoveredParticipant{} : found->second;
}

std::string DomainView::name_of(const DiscoveredEndpoint& endpoint) const {
  if (!endpoint.peer.service.empty()) return to_string(endpoint.peer);
  const bus::DiscoveredParticipant participant = participant_of(endpoint);
  if (participant.process.empty()) return vendor_of(endpoint.participant);
  return participant.process + "[" + std::to_string(participant.pid) + "]";
}

std::vector<DiscoveredEndpoint> DomainView::of_topic(const std::string& topic) const {
  std::vector<DiscoveredEndpoint> out;
  std::copy_if(endpoints.begin(), endpoints.end(), std::back_inserter(out),
               [&](const auto& endpoint) { return endpoint.topic == topic; });
  return out;
}

std::vector<DiscoveredEndpoint> DomainView::of_topic(const std::string& topic,
                                                     bus::EndpointKind kind) const {
  std::vector<DiscoveredEndpoint> out = of_topic(topic);
  out.erase(std::remove_if(out.begin(), out.end(),
                           [&](const auto& endpoint) { return endpoint.kind != kind; }),
            out.end());
  return out;
}

std::vector<std::string> DomainView::topics() const {
  std::vector<std::string> names;
  for (const DiscoveredEndpoint& endpoint : endpoints) names.push_back(endpoint.topic);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string vendor_of(const bus::Guid& guid) {
  // The numbers the OMG has given out; all begin with 1.
  constexpr std::array<std::pair<std::uint8_t, const char*>, 12> kVendors{
      {{0x01, "RTI Connext"},
       {0x02, "OpenSplice"},
       {0x03, "OpenDDS"},
       {0x06, "CoreDX"},
       {0x0a, "RTI Connext Micro"},
       {0x0b, "Vortex Cafe"},
       {0x0d, "Vortex Lite"},
       {0x0f, "Fast DDS"},
       {0x10, "Cyclone DDS"},
       {0x11, "GurumDDS"},
       {0x12, "RustDDS"},
       {0x14, "Dust DDS"}}};
  const auto found = std::find_if(kVendors.begin(), kVendors.end(),
                                  [&](const auto& vendor) { return vendor.first == guid[1]; });
  if (guid[0] == 1 && found != kVendors.end()) return found->second;
  constexpr const char* kHex = "0123456789abcdef";
  std::string number;
  for (const std::size_t i : {0U, 1U}) {
    number += {kHex[guid[i] >> 4U], kHex[guid[i] & 0xFU]};
    if (i == 0) number += '.';
  }
  return "vendor " + number;
}

}  // namespace scarab::topic
