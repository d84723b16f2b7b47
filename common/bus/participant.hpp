#pragma once

#include "common/bus/domain_config.hpp"
#include "common/bus/entity.hpp"
#include "common/bus/error.hpp"
#include "common/bus/peer.hpp"

namespace scarab::bus {

/// A member of a DDS domain; every other object of the bus is made on one and must not outlive it.
/// Configured from code (see domain_config); CYCLONEDDS_URI replaces the built-in configuration.
/// Several participants in one process are as separate as those of several processes.
class Participant {
 public:
  /// Throws Error: `interface eth7 not found`, or Cyclone's own words for the cause.
  explicit Participant(const ParticipantOptions& options);
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  const Peer& self() const { return options_.self; }
  const ParticipantOptions& options() const { return options_; }
  dds_entity_t handle() const { return participant_.handle(); }

 private:
  ParticipantOptions options_;
  Entity domain_;
  Entity participant_;
};

}  // namespace scarab::bus
