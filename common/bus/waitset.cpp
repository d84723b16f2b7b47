#include "common/bus/waitset.hpp"

#include <algorithm>

namespace scarab::bus {

Guard::Guard(Participant& participant)
    : guard_(check(dds_create_guardcondition(participant.handle()), "guard")) {}

void Guard::trigger() { check(dds_set_guardcondition(guard_.handle(), true), "guard"); }

void Guard::clear() { check(dds_set_guardcondition(guard_.handle(), false), "guard"); }

WaitSet::WaitSet(Participant& participant)
    : waitset_(check(dds_create_waitset(participant.handle()), "wait set")) {}

void WaitSet::attach_handle(dds_entity_t entity) {
  check(dds_waitset_attach(waitset_.handle(), entity, entity), "wait set");
}

void WaitSet::attach(const ReaderEndpoint& reader) { attach_handle(reader.condition()); }

void WaitSet::attach(const Guard& guard) { attach_handle(guard.handle()); }

void WaitSet::attach(const Discovery& discovery) {
  for (const dds_entity_t condition : discovery.conditions()) attach_handle(condition);
}

bool WaitSet::wait(std::chrono::nanoseconds timeout) {
  const dds_duration_t ns = std::max<std::int64_t>(0, timeout.count());
  return check(dds_waitset_wait(waitset_.handle(), nullptr, 0, ns), "wait set") > 0;
}

}  // namespace scarab::bus
