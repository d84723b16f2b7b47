#pragma once

#include <string>
#include <vector>

#include "common/bus/network_interface.hpp"

namespace scarab::bus {

/// Whom a participant on `interface` asks for others where there is no multicast: `peers`, and this
/// host, whose own processes are found in no other way then. Empty if `peers` is. Throws Error
/// naming a peer that is no host, or none that a loopback interface leads to.
std::vector<std::string> hosts_to_ask(const std::vector<std::string>& peers,
                                      const NetworkInterface& interface);

}  // namespace scarab::bus
