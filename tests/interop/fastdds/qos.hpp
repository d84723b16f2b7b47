#pragma once

#include <cstdint>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <string>

#include "tests/interop/fastdds/peer.hpp"

namespace scarab::fastdds {

/// The profiles of idl/README.md.
enum class Profile { kStream, kCommand, kState, kStatus };

/// A participant that meets Scarab's: on the network interface with this IPv4 address, and on no
/// other transport.
eprosima::fastdds::dds::DomainParticipantQos participant_qos(const std::string& address,
                                                             const Peer& self);

eprosima::fastdds::dds::DataWriterQos writer_qos(Profile profile, const Peer& self);

/// `keep_all`: for a recorder, which takes every sample, the last one before it came included.
eprosima::fastdds::dds::DataReaderQos reader_qos(Profile profile, const Peer& self, bool keep_all);

}  // namespace scarab::fastdds
