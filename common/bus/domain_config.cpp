#include "common/bus/domain_config.hpp"

namespace scarab::bus {

namespace {

// Ports that follow from the index of a process on its host, 0 to 63: who is asked, not heard, must
// answer where others can guess.
constexpr const char* kGuessablePorts =
    "<ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>63</MaxAutoParticipantIndex>";

std::string escape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      // Cyclone expands ${VARIABLE} in its configuration.
      case '$':
        out += "&#36;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

bool by_peers(const ParticipantOptions& options) { return !options.peers.empty(); }

std::string interfaces(const ParticipantOptions& options) {
  const bool is_address = options.interface.find_first_not_of("0123456789.") == std::string::npos ||
                          options.interface.find(':') != std::string::npos;
  return std::string("<Interfaces><NetworkInterface ") + (is_address ? "address" : "name") + "=\"" +
         escape(options.interface) + "\" multicast=\"" + (by_peers(options) ? "false" : "true") +
         "\"/></Interfaces>";
}

std::string multicast(const ParticipantOptions& options) {
  return std::string("<AllowMulticast>") + (by_peers(options) ? "false" : "spdp") +
         "</AllowMulticast>";
}

/// In which domain, and with whom.
std::string whereabouts(const ParticipantOptions& options) {
  // Participants of one process each get a Cyclone domain of their own; on the network they are in
  // the same one through the external identifier.
  std::string out = "<ExternalDomainId>" + std::to_string(options.domain) + "</ExternalDomainId>";
  if (!options.tag.empty()) out += "<Tag>" + escape(options.tag) + "</Tag>";
  if (!by_peers(options)) return out;
  out += "<Peers>";
  for (const auto& peer : options.peers) out += "<Peer address=\"" + escape(peer) + "\"/>";
  return out + "</Peers>";
}

std::string document(const ParticipantOptions& options, const std::string& general,
                     const std::string& discovery) {
  std::string out = "<CycloneDDS xmlns=\"https://cdds.io/config\"><Domain Id=\"any\">";
  if (!general.empty()) out += "<General>" + general + "</General>";
  out += "<Discovery>" + discovery + "</Discovery>";
  // Cyclone 0.10 knows this for all writers of a domain only: those that do not gather flush each
  // sample (endpoint.cpp).
  if (options.gathers_samples) out += "<Internal><WriteBatch>true</WriteBatch></Internal>";
  return out + "</Domain></CycloneDDS>";
}

/// What the options that differ from their defaults change of a configuration of the user's own.
std::string overlay(const ParticipantOptions& options) {
  std::string general;
  if (options.interface != kDefaultInterface) general += interfaces(options);
  if (by_peers(options)) general += multicast(options);
  return document(options, general,
                  (by_peers(options) ? kGuessablePorts : "") + whereabouts(options));
}

}  // namespace

std::string domain_config(const ParticipantOptions& options,
                          const std::optional<std::string>& base) {
  if (base.has_value()) return *base + "," + overlay(options);
  // Longer than any wait of a running trial: a process that is stopped or starved for less is not
  // forgotten, so nothing sent meanwhile is lost. That it is silent shows in service_status after 1
  // s.
  // An announcement that nobody heard is repeated after SPDPInterval; else after most of the lease,
  // and by then a running trial that waits for a restarted service has been given up.
  return document(options, interfaces(options) + multicast(options),
                  kGuessablePorts + ("<LeaseDuration>12s</LeaseDuration>"
                                     "<SPDPInterval>1s</SPDPInterval>" +
                                     whereabouts(options)));
}

}  // namespace scarab::bus
