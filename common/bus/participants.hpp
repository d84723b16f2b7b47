#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "common/bus/discovery.hpp"

namespace scarab::bus {

/// A participant somebody has in the domain. What it does not say of itself is empty: Cyclone's
/// participants tell their process and host, those of other vendors mostly not.
struct DiscoveredParticipant {
  Guid guid{};
  Peer peer;
  std::string process;    ///< file name of its program
  std::uint32_t pid = 0;  ///< on its host
  std::string host;
};

/// Watches who is in the domain, this process included.
class Participants {
 public:
  explicit Participants(Participant& participant);

  /// Takes in what was announced since the last call.
  void update();
  const std::map<Guid, DiscoveredParticipant>& all() const { return participants_; }
  /// The participant of this process that watches.
  const Guid& self() const { return self_; }

 private:
  Entity reader_;
  Entity condition_;
  Guid self_{};
  std::map<Guid, DiscoveredParticipant> participants_;
};

}  // namespace scarab::bus
