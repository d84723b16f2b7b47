#pragma once

#include <sys/socket.h>

#include <optional>
#include <string>
#include <vector>

namespace scarab::bus {

/// A network interface of this host, with its addresses.
struct NetworkInterface {
  std::string name;
  std::vector<std::string> addresses;  ///< numeric; the IPv4 ones first
};

/// An IPv4 or IPv6 address in digits; empty for any other, and for none.
std::string address_text(const sockaddr* address);

/// The interface that has this name or this address; nothing if there is none.
std::optional<NetworkInterface> find_interface(const std::string& name_or_address);

}  // namespace scarab::bus
