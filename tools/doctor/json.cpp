#include "common/config/json.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "tools/doctor/survey.hpp"

namespace scarab::doctor {
namespace {

using bus::DiscoveredEndpoint;
using bus::DiscoveredParticipant;

using config::in_json_quotes;

/// `"key": value` pairs of who somebody is, without the brackets.
std::string who(const DiscoveredParticipant& participant, const bus::Peer& peer) {
  return "\"service\": " + in_json_quotes(peer.service.empty() ? "" : bus::to_string(peer)) +
         ", \"process\": " + in_json_quotes(participant.process) +
         ", \"pid\": " + std::to_string(participant.pid) +
         ", \"host\": " + in_json_quotes(participant.host);
}

std::string who(const Survey& survey, const DiscoveredEndpoint& endpoint) {
  const auto found = survey.participants.find(endpoint.participant);
  return "{" +
         who(found == survey.participants.end() ? DiscoveredParticipant{} : found->second,
             endpoint.peer) +
         "}";
}

std::string topics_of(const Survey& survey, const bus::Guid& participant) {
  std::set<std::string> topics;
  for (const auto& endpoint : survey.endpoints) {
    if (endpoint.participant == participant) topics.insert(endpoint.topic);
  }
  std::string out;
  for (const auto& topic : topics) out += (out.empty() ? "" : ", ") + in_json_quotes(topic);
  return "[" + out + "]";
}

}  // namespace

std::string json(const Survey& survey, const std::vector<bus::EndpointFault>& faults) {
  std::string participants;
  for (const auto& [guid, participant] : survey.participants) {
    participants += (participants.empty() ? "\n  {" : ",\n  {") +
                    who(participant, participant.peer) +
                    ", \"topics\": " + topics_of(survey, guid) + "}";
  }
  std::string mismatches;
  for (const bus::EndpointFault& fault : faults) {
    mismatches += (mismatches.empty() ? "\n  {" : ",\n  {");
    mismatches += "\"topic\": " + in_json_quotes(fault.writer.topic) +
                  ", \"policy\": " + in_json_quotes(fault.policy) +
                  ", \"offered\": " + in_json_quotes(fault.offered) +
                  ", \"asked\": " + in_json_quotes(fault.asked);
    mismatches += ", \"writer\": " + who(survey, fault.writer) +
                  ", \"reader\": " + who(survey, fault.reader) + "}";
  }
  return "{\"participants\": [" + participants + "],\n \"mismatches\": [" + mismatches + "]}\n";
}

}  // namespace scarab::doctor
