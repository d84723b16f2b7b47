#include "tools/topic/offered_qos.hpp"

#include <gmock/gmock.h>

#include "common/bus/compatibility.hpp"
#include "common/bus/topics.hpp"

namespace scarab::topic {
namespace {

using bus::EndpointKind;
using bus::RawQos;
using testing::UnorderedElementsAre;

bus::DiscoveredEndpoint endpoint(EndpointKind kind, const RawQos& qos) {
  bus::DiscoveredEndpoint out;
  out.kind = kind;
  out.qos = std::shared_ptr<const dds_qos_t>(bus::dds_qos_of(qos));
  return out;
}

void expect_match(const RawQos& offered, const bus::DiscoveredEndpoint& reader) {
  EXPECT_TRUE(bus::mismatches(*bus::dds_qos_of(offered), *reader.qos).empty());
}

TEST(OfferedQos, IsTheProfileOfATopicOfTheProject) {
  const RawQos status = offered_qos(bus::kServiceStatus.name, {});
  EXPECT_EQ(status.durability, DDS_DURABILITY_TRANSIENT_LOCAL);
  EXPECT_EQ(status.liveliness_lease, std::chrono::seconds(1));
  const RawQos other = offered_qos("a", {});
  EXPECT_EQ(other.reliability, DDS_RELIABILITY_RELIABLE);
  EXPECT_FALSE(other.liveliness_lease);
}

TEST(OfferedQos, IsStrongEnoughForEveryReader) {
  RawQos first;
  first.deadline = std::chrono::seconds(2);
  first.liveliness = DDS_LIVELINESS_MANUAL_BY_TOPIC;
  first.partitions = {"left*", "middle"};
  RawQos second;
  second.durability = DDS_DURABILITY_TRANSIENT_LOCAL;
  second.deadline = std::chrono::seconds(1);
  second.liveliness_lease = std::chrono::seconds(3);
  const auto one = endpoint(EndpointKind::kReader, first);
  const auto two = endpoint(EndpointKind::kReader, second);
  RawQos weak;
  weak.reliability = DDS_RELIABILITY_BEST_EFFORT;
  const RawQos offered = offered_qos("a", {endpoint(EndpointKind::kWriter, weak), one, two});
  expect_match(offered, one);
  expect_match(offered, two);
  EXPECT_THAT(offered.partitions, UnorderedElementsAre("left", "middle", ""));
  EXPECT_EQ(offered.deadline, std::chrono::seconds(1));
}

TEST(OfferedQos, FollowsTheWritersThereAre) {
  RawQos there;
  there.ownership = DDS_OWNERSHIP_EXCLUSIVE;
  there.partitions = {"left"};
  there.xcdr2 = true;
  const RawQos offered = offered_qos("a", {endpoint(EndpointKind::kWriter, there)});
  EXPECT_EQ(offered.ownership, DDS_OWNERSHIP_EXCLUSIVE);
  EXPECT_THAT(offered.partitions, UnorderedElementsAre("left"));
  EXPECT_TRUE(offered.xcdr2);
}

}  // namespace
}  // namespace scarab::topic
