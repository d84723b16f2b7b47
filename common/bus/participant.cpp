#include "common/bus/participant.hpp"

#include <cstdlib>
#include <optional>

#include "common/bus/cyclone_log.hpp"
#include "common/bus/network_interface.hpp"
#include "common/bus/peer_hosts.hpp"
#include "common/bus/qos.hpp"

namespace scarab::bus {

namespace {

constexpr std::uint32_t kLargestDomain = 230;  // the UDP ports of domain 231 are beyond 65535

/// A Cyclone domain of its own for one participant: the DDS domain's number if this process does
/// not use it yet, else the next free number beyond all DDS domains.
Entity create_domain(const ParticipantOptions& options, const std::string& config) {
  constexpr std::uint32_t kMostInOneProcess = 256;
  dds_return_t code = dds_create_domain(options.domain, config.c_str());
  for (std::uint32_t i = 1; code == DDS_RETCODE_PRECONDITION_NOT_MET && i < kMostInOneProcess;
       ++i) {
    code = dds_create_domain(options.domain + i * 1000, config.c_str());
  }
  check(code, "domain " + std::to_string(options.domain));
  return Entity(code);
}

Qos participant_qos(const Peer& self) {
  Qos qos(dds_create_qos());
  set_peer(*qos, self);
  return qos;
}

}  // namespace

Participant::Participant(const ParticipantOptions& options) : options_(options) {
  if (options.domain > kLargestDomain) {
    throw Error("domain " + std::to_string(options.domain) + " out of range: 0 to 230");
  }
  const char* uri = std::getenv("CYCLONEDDS_URI");
  const bool has_base = uri != nullptr && *uri != '\0';
  const bool own_interface = !has_base || options.interface != kDefaultInterface;
  const auto interface = find_interface(options.interface);
  if (own_interface && !interface) throw Error("interface " + options.interface + " not found");
  if (own_interface) options_.peers = hosts_to_ask(options.peers, *interface);
  const CycloneLog log;
  try {
    domain_ = create_domain(
        options_,
        domain_config(options_, has_base ? std::optional<std::string>(uri) : std::nullopt));
    dds_domainid_t id = 0;
    check(dds_get_domainid(domain_.handle(), &id), "domain");
    const Qos qos = participant_qos(options.self);
    participant_ = Entity(check(dds_create_participant(id, qos.get(), nullptr), "participant"));
  } catch (const Error& error) {
    const std::string cause = log.text();
    throw Error("participant " + to_string(options.self) + " in domain " +
                std::to_string(options.domain) + ": " + (cause.empty() ? error.what() : cause));
  }
}

}  // namespace scarab::bus
