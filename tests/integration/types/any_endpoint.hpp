#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/bus/discovery.hpp"
#include "common/bus/endpoint.hpp"
#include "common/bus/raw_cdr.hpp"
#include "common/bus/raw_qos.hpp"
#include "tests/support/eventually.hpp"

namespace scarab::test {

inline bus::RawQos kept() {
  bus::RawQos qos;
  qos.durability = DDS_DURABILITY_TRANSIENT_LOCAL;
  return qos;
}

/// A writer of a compiled type, as any program on Cyclone DDS has it.
class AnyWriter : public bus::WriterEndpoint {
 public:
  AnyWriter(bus::Participant& participant, const std::string& topic,
            const dds_topic_descriptor_t& type, const bus::RawQos& qos = kept())
      : WriterEndpoint(participant, topic.c_str(), type, bus::dds_qos_of(qos)) {}

  void write(const void* sample) { send(sample, dds_time()); }
};

/// A reader of a compiled type whose samples are looked at as bytes.
class AnyReader : public bus::ReaderEndpoint {
 public:
  AnyReader(bus::Participant& participant, const std::string& topic,
            const dds_topic_descriptor_t& type, const bus::RawQos& qos = kept())
      : ReaderEndpoint(participant, topic.c_str(), type, bus::dds_qos_of(qos)) {}
};

/// The endpoint that is announced on a topic; waits for it.
inline bus::DiscoveredEndpoint discover(bus::Discovery& discovery, const std::string& topic) {
  bus::DiscoveredEndpoint found;
  const bool announced = eventually([&] {
    for (const auto& endpoint : discovery.update()) {
      if (endpoint.topic == topic) found = endpoint;
    }
    return !found.topic.empty();
  });
  EXPECT_TRUE(announced) << "nobody on " << topic;
  return found;
}

struct Taken {
  sample::Bytes cdr;
  std::int64_t source_ns = 0;
};

/// The samples a reader gets until it has `count` of them; fewer when it takes too long.
inline std::vector<Taken> take_some(const bus::ReaderEndpoint& reader, std::size_t count) {
  std::vector<Taken> out;
  eventually([&] {
    bus::take_raw(reader.handle(), [&](const bus::RawSample& sample) {
      out.push_back({{sample.cdr.data, sample.cdr.data + sample.cdr.size}, sample.source_ns});
    });
    return out.size() >= count;
  });
  return out;
}

}  // namespace scarab::test
