#include "tools/topic/domain_view.hpp"

#include <gmock/gmock.h>

#include "tools/topic/process_list.hpp"
#include "tools/topic/topic_report.hpp"

namespace scarab::topic {
namespace {

using testing::ElementsAre;

bus::Guid guid(std::uint8_t vendor, std::uint8_t number) {
  bus::Guid out{};
  out[0] = 1;
  out[1] = vendor;
  out[15] = number;
  return out;
}

/// A Cyclone process, one of Fast DDS that says nothing of itself, and a service.
struct Domain : testing::Test {
  DomainView view;

  Domain() {
    view.participants[guid(0x10, 1)] = {guid(0x10, 1), {}, "ddsperf", 312, "alder"};
    view.participants[guid(0x0f, 2)] = {guid(0x0f, 2), {}, "", 0, ""};
    view.participants[guid(0x10, 3)] = {guid(0x10, 3), {"plant", 0}, "scarab-plant", 7, "birch"};
    add("b", guid(0x10, 1), bus::EndpointKind::kWriter, {});
    add("a", guid(0x0f, 2), bus::EndpointKind::kReader, {});
    add("a", guid(0x10, 3), bus::EndpointKind::kWriter, {"plant", 0});
    add("a", guid(0x10, 3), bus::EndpointKind::kWriter, {"plant", 0});
  }

  void add(const std::string& topic, const bus::Guid& participant, bus::EndpointKind kind,
           const bus::Peer& peer) {
    bus::DiscoveredEndpoint endpoint;
    endpoint.topic = topic;
    endpoint.participant = participant;
    endpoint.kind = kind;
    endpoint.peer = peer;
    view.endpoints.push_back(endpoint);
  }
};

TEST_F(Domain, NamesEverybodyAsWellAsItCan) {
  EXPECT_EQ(names_of(view, view.of_topic("a")), "Fast DDS, plant/0 (2)");
  EXPECT_EQ(names_of(view, view.of_topic("a"), 1), "Fast DDS +1");
  EXPECT_EQ(names_of(view, view.of_topic("b")), "ddsperf[312]");
  EXPECT_EQ(names_of(view, {}), "-");
  EXPECT_THAT(view.topics(), ElementsAre("a", "b"));
  EXPECT_EQ(view.of_topic("a", bus::EndpointKind::kWriter).size(), 2U);
}

TEST_F(Domain, KnowsVendorsByTheirNumbers) {
  EXPECT_EQ(vendor_of(guid(0x10, 0)), "Cyclone DDS");
  EXPECT_EQ(vendor_of(guid(0x42, 0)), "vendor 01.42");
  EXPECT_EQ(vendor_of({}), "vendor 00.00");
}

TEST_F(Domain, ListsProcesses) {
  EXPECT_EQ(process_table(process_list(view)),
            "SERVICE  PROGRAM       PID  HOST   VENDOR       WRITERS  READERS\n"
            "-        -               -  -      Fast DDS           0        1\n"
            "-        ddsperf       312  alder  Cyclone DDS        1        0\n"
            "plant/0  scarab-plant    7  birch  Cyclone DDS        2        0\n");
}

}  // namespace
}  // namespace scarab::topic
