#include "tests/interop/fastdds/qos.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <memory>

namespace scarab::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::Duration_t;

constexpr int kDepth = 64;

/// What readers and writers have in common.
template <class EndpointQos>
void set_common(EndpointQos& qos, Profile profile, const Peer& self) {
  const std::string user_data = user_data_of(self);
  qos.user_data().setValue({user_data.begin(), user_data.end()});
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = profile == Profile::kStatus ? 1 : kDepth;
  if (profile == Profile::kStatus) {
    qos.liveliness().kind = dds::AUTOMATIC_LIVELINESS_QOS;
    qos.liveliness().lease_duration = Duration_t(1, 0);
    qos.liveliness().announcement_period = Duration_t(0.3);
  }
  // Samples have no largest size where a type has strings or sequences without a bound.
  qos.endpoint().history_memory_policy =
      eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
}

}  // namespace

dds::DomainParticipantQos participant_qos(const std::string& address, const Peer& self) {
  dds::DomainParticipantQos qos;
  const std::string user_data = user_data_of(self);
  qos.user_data().setValue({user_data.begin(), user_data.end()});
  qos.name(user_data.c_str());
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {address};
  qos.transport().use_builtin_transports = false;  // shared memory among them
  qos.transport().user_transports.push_back(udp);
  auto& discovery = qos.wire_protocol().builtin.discovery_config;
  discovery.leaseDuration = Duration_t(12, 0);
  discovery.leaseDuration_announcementperiod = Duration_t(1, 0);
  return qos;
}

dds::DataWriterQos writer_qos(Profile profile, const Peer& self) {
  dds::DataWriterQos qos;
  set_common(qos, profile, self);
  // A restarted service goes on where it was: what it wrote before is not to be disposed of.
  qos.writer_data_lifecycle().autodispose_unregistered_instances = false;
  // A sample that was lost is asked for after a heartbeat; Fast DDS sends one in 3 s by itself.
  qos.reliable_writer_qos().times.heartbeatPeriod = Duration_t(0.1);
  return qos;
}

dds::DataReaderQos reader_qos(Profile profile, const Peer& self, bool keep_all) {
  dds::DataReaderQos qos;
  set_common(qos, profile, self);
  if (keep_all) {
    qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;
    qos.resource_limits().max_samples = dds::LENGTH_UNLIMITED;
    qos.resource_limits().max_instances = dds::LENGTH_UNLIMITED;
    qos.resource_limits().max_samples_per_instance = dds::LENGTH_UNLIMITED;
  } else if (profile == Profile::kStream) {
    qos.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  }
  return qos;
}

}  // namespace scarab::fastdds
