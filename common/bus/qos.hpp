#pragma once

#include <optional>

#include "common/bus/entity.hpp"
#include "common/bus/peer.hpp"
#include "common/bus/profile.hpp"

namespace scarab::bus {

/// How a reader departs from its topic's profile.
struct ReaderOptions {
  bool best_effort = false;  ///< for views: never slows a writer, may miss samples
  /// For who must miss nothing: unlimited history, and transient-local, so that nothing is dropped
  /// between the match and a writer's first heartbeat.
  bool keep_all = false;
  std::optional<int> depth;  ///< another depth of keep-last history
};

/// The policies of a profile for a writer. Autodispose is off: a dead writer unregisters its
/// instances, so that the late death notice of a killed service does not dispose of what its
/// successor wrote.
Qos writer_qos(Profile profile);

/// The policies of a profile for a reader.
Qos reader_qos(Profile profile, const ReaderOptions& options = {});

/// Puts `self` into the user data of an entity's QoS.
void set_peer(dds_qos_t& qos, const Peer& self);

/// The peer in the user data of a discovered entity's QoS; foreign when there is none.
Peer get_peer(const dds_qos_t* qos);

/// The name of a policy as in the DDS standard, lower case: "durability", "reliability", ...
const char* policy_name(std::uint32_t policy_id);

}  // namespace scarab::bus
