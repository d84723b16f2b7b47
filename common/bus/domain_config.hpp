#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/peer.hpp"

namespace scarab::bus {

/// The network interface a participant uses when nothing else is said: loopback.
inline constexpr const char* kDefaultInterface = "lo";

struct ParticipantOptions {
  std::uint32_t domain = 0;                   ///< DDS domain, 0 to 230
  std::string tag;                            ///< Cyclone's discovery tag; empty: none
  std::string interface = kDefaultInterface;  ///< name or address of a network interface
  Peer self;                                  ///< who the participant's endpoints say they are
  /// Addresses or names of the other hosts, for a network without multicast; empty: multicast finds
  /// everybody.
  std::vector<std::string> peers = {};
  /// What is given to Writer::stage() leaves with flush(), many samples in a packet; else at once.
  bool gathers_samples = false;
};

/// The Cyclone DDS configuration of a participant.
///
/// Without `base` it is the built-in one: the given interface, discovery by multicast or, where
/// `peers` are given, by asking each of them; up to 64 participants a host, a lost process
/// forgotten after 12 s, an announcement repeated every second. With `base` (the text of
/// CYCLONEDDS_URI) it is the base, over which the options that differ from their defaults are laid.
std::string domain_config(const ParticipantOptions& options,
                          const std::optional<std::string>& base);

}  // namespace scarab::bus
