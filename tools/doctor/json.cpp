#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

#include "tools/doctor/survey.hpp"

namespace scarab::doctor {
namespace {

using bus::DiscoveredEndpoint;
using bus::DiscoveredParticipant;

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out << '\\' << c;
    } else if (code < 0x20) {
      out << "\\u" << std::hex << std::setw(4) << std::setfill('0') << static_cast<int>(code)
          << std::dec;
    } else {
      out << c;
    }
  }
  out << '"';
  return out.str();
}

/// `"key": value` pairs of who somebody is, without the brackets.
std::string who(const DiscoveredParticipant& participant, const bus::Peer& peer) {
  return "\"service\": " + quoted(peer.service.empty() ? "" : bus::to_string(peer)) +
         ", \"process\": " + quoted(participant.process) +
         ", \"pid\": " + std::to_string(participant.pid) +
         ", \"host\": " + quoted(participant.host);
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
  for (const auto& topic : topics) out += (out.empty() ? "" : ", ") + quoted(topic);
  return "[" + out + "]";
}

}  // namespace

std::string json(const Survey& survey, const std::vector<Fault>& faults) {
  std::string participants;
  for (const auto& [guid, participant] : survey.participants) {
    participants += (participants.empty() ? "\n  {" : ",\n  {") +
                    who(participant, participant.peer) +
                    ", \"topics\": " + topics_of(survey, guid) + "}";
  }
  std::string mismatches;
  for (const Fault& fault : faults) {
    mismatches += (mismatches.empty() ? "\n  {" : ",\n  {");
    mismatches += "\"topic\": " + quoted(fault.writer.topic) +
                  ", \"policy\": " + quoted(fault.policy) +
                  ", \"offered\": " + quoted(fault.offered) + ", \"asked\": " + quoted(fault.asked);
    mismatches += ", \"writer\": " + who(survey, fault.writer) +
                  ", \"reader\": " + who(survey, fault.reader) + "}";
  }
  return "{\"participants\": [" + participants + "],\n \"mismatches\": [" + mismatches + "]}\n";
}

}  // namespace scarab::doctor
