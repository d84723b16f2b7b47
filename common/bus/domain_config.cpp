#include "common/bus/domain_config.hpp"

namespace scarab::bus {

namespace {

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

std::string interfaces(const ParticipantOptions& options) {
  const bool is_address = options.interface.find_first_not_of("0123456789.") == std::string::npos ||
                          options.interface.find(':') != std::string::npos;
  return std::string("<Interfaces><NetworkInterface ") + (is_address ? "address" : "name") + "=\"" +
         escape(options.interface) + "\" multicast=\"true\"/></Interfaces>";
}

std::string discovery(const ParticipantOptions& options) {
  // Participants of one process each get a Cyclone domain of their own; on the network they are in
  // the same one through the external identifier.
  std::string out = "<ExternalDomainId>" + std::to_string(options.domain) + "</ExternalDomainId>";
  if (!options.tag.empty()) out += "<Tag>" + escape(options.tag) + "</Tag>";
  return out;
}

std::string document(const std::string& general, const std::string& discovery) {
  std::string out = "<CycloneDDS xmlns=\"https://cdds.io/config\"><Domain Id=\"any\">";
  if (!general.empty()) out += "<General>" + general + "</General>";
  return out + "<Discovery>" + discovery + "</Discovery></Domain></CycloneDDS>";
}

}  // namespace

std::string domain_config(const ParticipantOptions& options,
                          const std::optional<std::string>& base) {
  if (base.has_value()) {
    const bool explicit_interface = options.interface != kDefaultInterface;
    return *base + "," +
           document(explicit_interface ? interfaces(options) : "", discovery(options));
  }
  // Longer than any wait of a running trial: a process that is stopped or starved for less is not
  // forgotten, so nothing sent meanwhile is lost. That it is silent shows in service_status after 1
  // s.
  return document(interfaces(options) + "<AllowMulticast>spdp</AllowMulticast>",
                  "<ParticipantIndex>auto</ParticipantIndex>"
                  "<MaxAutoParticipantIndex>63</MaxAutoParticipantIndex>"
                  "<LeaseDuration>12s</LeaseDuration>" +
                      discovery(options));
}

}  // namespace scarab::bus
