#include "common/bus/participants.hpp"

#include <algorithm>
#include <charconv>

#include "common/bus/loan.hpp"
#include "common/bus/qos.hpp"

namespace scarab::bus {

namespace {

Guid guid_of(const dds_guid_t& from) {
  Guid out{};
  std::copy_n(from.v, out.size(), out.begin());
  return out;
}

std::string property(const dds_qos_t& qos, const char* name) {
  char* value = nullptr;
  if (!dds_qget_prop(&qos, name, &value) || value == nullptr) return {};
  std::string text = value;
  dds_free(value);
  return text;
}

DiscoveredParticipant discovered(const dds_builtintopic_participant_t& from) {
  DiscoveredParticipant out;
  out.guid = guid_of(from.key);
  if (from.qos == nullptr) return out;
  out.peer = get_peer(from.qos);
  out.process = property(*from.qos, "__ProcessName");
  out.host = property(*from.qos, "__Hostname");
  const std::string pid = property(*from.qos, "__Pid");
  std::from_chars(pid.data(), pid.data() + pid.size(), out.pid);
  return out;
}

}  // namespace

Participants::Participants(Participant& participant)
    : reader_(check(dds_create_reader(participant.handle(), DDS_BUILTIN_TOPIC_DCPSPARTICIPANT,
                                      nullptr, nullptr),
                    "discovery")),
      condition_(check(dds_create_readcondition(reader_.handle(), DDS_NOT_READ_SAMPLE_STATE |
                                                                      DDS_ANY_VIEW_STATE |
                                                                      DDS_ANY_INSTANCE_STATE),
                       "discovery")) {
  dds_guid_t guid{};
  check(dds_get_guid(participant.handle(), &guid), "participant");
  self_ = guid_of(guid);
}

void Participants::update() {
  while (true) {
    const Loan loan = Loan::read(condition_.handle(), "discovery");
    for (std::size_t i = 0; i < loan.size(); ++i) {
      const auto& found = *static_cast<const dds_builtintopic_participant_t*>(loan.sample(i));
      if (loan.info(i).instance_state != DDS_ALIVE_INSTANCE_STATE) {
        participants_.erase(guid_of(found.key));
      } else if (loan.info(i).valid_data) {
        participants_[guid_of(found.key)] = discovered(found);
      }
    }
    if (loan.size() < Loan::kCapacity) return;
  }
}

}  // namespace scarab::bus
