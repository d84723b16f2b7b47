#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "common/bus/peer.hpp"
#include "common/runtime/peers.hpp"

/// Who may be the tick master of a stack: there is one in each, and every service but its own asks
/// for whichever is expected.
namespace scarab::runtime {

inline constexpr std::array<const char*, 2> kTickMasters = {"plant", "robot_bridge"};

[[nodiscard]] inline bool is_tick_master(const bus::Peer& peer) {
  return std::find(kTickMasters.begin(), kTickMasters.end(), peer.service) != kTickMasters.end();
}

/// The one that is expected; none: nobody is.
[[nodiscard]] inline std::optional<bus::Peer> expected_tick_master(const Expectation& expect) {
  for (const std::string service : kTickMasters) {
    const auto entry = expect.find(service);
    if (entry != expect.end() && entry->second > 0) return bus::Peer{service, 0};
  }
  return std::nullopt;
}

/// `endpoint` needs the tick master at its other end (PeerCheck::need).
template <class Endpoint>
void need_tick_master(PeerCheck& peers, const Endpoint& endpoint) {
  for (const char* service : kTickMasters) peers.need(endpoint, service);
}

}  // namespace scarab::runtime
