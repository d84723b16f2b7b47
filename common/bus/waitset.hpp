#pragma once

#include <chrono>

#include "common/bus/discovery.hpp"
#include "common/bus/endpoint.hpp"
#include "common/bus/entity.hpp"
#include "common/bus/participant.hpp"

namespace scarab::bus {

/// Wakes a WaitSet from another thread. Not for signal handlers.
class Guard {
 public:
  explicit Guard(Participant& participant);
  /// From now on every wait returns at once, until clear().
  void trigger();
  void clear();
  dds_entity_t handle() const { return guard_.handle(); }

 private:
  Entity guard_;
};

/// Sleeps until one of the attached readers has samples or one of the attached guards is triggered,
/// or an attached Discovery has news. What is attached may be destroyed before the WaitSet.
class WaitSet {
 public:
  explicit WaitSet(Participant& participant);
  void attach(const ReaderEndpoint& reader);
  void attach(const Guard& guard);
  void attach(const Discovery& discovery);

  /// True: something is ready (and stays so until the samples are taken or the guard is cleared).
  /// False: the timeout passed. A timeout <= 0 only looks.
  bool wait(std::chrono::nanoseconds timeout);

 private:
  void attach_handle(dds_entity_t entity);

  Entity waitset_;
};

}  // namespace scarab::bus
