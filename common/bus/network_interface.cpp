#include "common/bus/network_interface.hpp"

#include <ifaddrs.h>
#include <netdb.h>

#include <algorithm>
#include <array>
#include <memory>

namespace scarab::bus {

std::string address_text(const sockaddr* address) {
  if (address == nullptr) return {};
  const int family = address->sa_family;
  if (family != AF_INET && family != AF_INET6) return {};
  const auto size =
      static_cast<socklen_t>(family == AF_INET ? sizeof(sockaddr_in) : sizeof(sockaddr_in6));
  std::array<char, NI_MAXHOST> text{};
  const int failed =
      getnameinfo(address, size, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST);
  return failed != 0 ? std::string{} : std::string(text.data());
}

namespace {

/// One entry an interface, as getifaddrs lists them: one entry an address.
std::vector<NetworkInterface> all_interfaces() {
  ifaddrs* raw = nullptr;
  if (getifaddrs(&raw) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> entries(raw, &freeifaddrs);
  std::vector<NetworkInterface> all;
  for (const ifaddrs* entry = raw; entry != nullptr; entry = entry->ifa_next) {
    auto known = std::find_if(all.begin(), all.end(),
                              [&](const auto& one) { return one.name == entry->ifa_name; });
    if (known == all.end()) known = all.insert(all.end(), {entry->ifa_name, {}});
    const std::string address = address_text(entry->ifa_addr);
    if (address.empty()) continue;
    const bool first = entry->ifa_addr->sa_family == AF_INET;
    known->addresses.insert(first ? known->addresses.begin() : known->addresses.end(), address);
  }
  return all;
}

}  // namespace

std::optional<NetworkInterface> find_interface(const std::string& name_or_address) {
  for (const NetworkInterface& one : all_interfaces()) {
    const auto& addresses = one.addresses;
    if (one.name == name_or_address ||
        std::find(addresses.begin(), addresses.end(), name_or_address) != addresses.end()) {
      return one;
    }
  }
  return std::nullopt;
}

}  // namespace scarab::bus
