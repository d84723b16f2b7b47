#include "common/bus/peer_hosts.hpp"

#include <netdb.h>

#include <memory>

#include "common/bus/error.hpp"

namespace scarab::bus {
namespace {

bool is_loopback(const std::string& address) { return address.rfind("127.", 0) == 0; }

/// The numeric address of a host; Cyclone itself passes over a name it cannot resolve.
std::string resolve(const std::string& host) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_DGRAM;
  addrinfo* raw = nullptr;
  const int code = getaddrinfo(host.c_str(), nullptr, &wanted, &raw);
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> found(raw, &freeaddrinfo);
  const auto address = code == 0 ? address_text(found->ai_addr) : std::string();
  if (address.empty()) throw Error("peer " + host + ": no such host");
  return address;
}

}  // namespace

std::vector<std::string> hosts_to_ask(const std::vector<std::string>& peers,
                                      const NetworkInterface& interface) {
  if (peers.empty() || interface.addresses.empty()) return peers;
  const std::string& own = interface.addresses.front();
  std::vector<std::string> hosts;
  for (const auto& peer : peers) {
    hosts.push_back(resolve(peer));
    if (is_loopback(own) && !is_loopback(hosts.back())) {
      throw Error("peer " + peer + " cannot be reached over " + interface.name +
                  ": name the interface that leads there");
    }
  }
  hosts.push_back(own);
  return hosts;
}

}  // namespace scarab::bus
