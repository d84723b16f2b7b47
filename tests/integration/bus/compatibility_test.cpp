// What Cyclone matches is what mismatches() calls a match, for every pair of odd endpoints.
#include "common/bus/compatibility.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "common/bus/discovery.hpp"
#include "common/bus/topic.hpp"
#include "tests/integration/bus/fixture.hpp"

namespace scarab::bus {
namespace {

constexpr const char* kTopic = "test/compatibility";

using Oddness = std::function<void(dds_qos_t*)>;

/// Each departs from the default in one or two policies.
const std::vector<Oddness>& oddnesses() {
  static const char* field = "field";
  static const char* wide = "f*";
  static const char* none = "";
  static const std::vector<Oddness> all = {
      [](dds_qos_t*) {},
      [](dds_qos_t* qos) { dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, 0); },
      [](dds_qos_t* qos) { dds_qset_reliability(qos, DDS_RELIABILITY_BEST_EFFORT, 0); },
      [](dds_qos_t* qos) { dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL); },
      [](dds_qos_t* qos) { dds_qset_ownership(qos, DDS_OWNERSHIP_EXCLUSIVE); },
      [](dds_qos_t* qos) { dds_qset_deadline(qos, DDS_MSECS(20)); },
      [](dds_qos_t* qos) { dds_qset_deadline(qos, DDS_MSECS(500)); },
      [](dds_qos_t* qos) { dds_qset_latency_budget(qos, DDS_MSECS(5)); },
      [](dds_qos_t* qos) { dds_qset_liveliness(qos, DDS_LIVELINESS_AUTOMATIC, DDS_SECS(1)); },
      [](dds_qos_t* qos) { dds_qset_liveliness(qos, DDS_LIVELINESS_MANUAL_BY_TOPIC, DDS_SECS(2)); },
      [](dds_qos_t* qos) {
        dds_qset_destination_order(qos, DDS_DESTINATIONORDER_BY_SOURCE_TIMESTAMP);
      },
      [](dds_qos_t* qos) { dds_qset_partition(qos, 1, &field); },
      [](dds_qos_t* qos) { dds_qset_partition(qos, 1, &wide); },
      [](dds_qos_t* qos) { dds_qset_partition(qos, 1, &none); },
  };
  return all;
}

Guid guid_of(dds_entity_t entity) {
  dds_guid_t raw{};
  EXPECT_EQ(dds_get_guid(entity, &raw), DDS_RETCODE_OK);
  Guid guid{};
  std::copy_n(raw.v, guid.size(), guid.begin());
  return guid;
}

/// Participants of one topic, one endpoint for each oddness.
class Side {
 public:
  Side(const std::string& name,
       dds_entity_t (*create)(dds_entity_t, dds_entity_t, const dds_qos_t*, const dds_listener_t*))
      : participant_(test_options(name)),
        topic_(check(dds_create_topic(participant_.handle(), &scarab_Operator_desc, kTopic, nullptr,
                                      nullptr),
                     kTopic)) {
    for (const Oddness& oddness : oddnesses()) {
      const Qos qos(dds_create_qos());
      oddness(qos.get());
      endpoints_.emplace_back(
          check(create(participant_.handle(), topic_.handle(), qos.get(), nullptr), kTopic));
    }
  }
  [[nodiscard]] const std::vector<Entity>& endpoints() const { return endpoints_; }

 private:
  Participant participant_;
  Entity topic_;
  std::vector<Entity> endpoints_;
};

std::set<Guid> matched_readers(dds_entity_t writer) {
  std::vector<dds_instance_handle_t> handles(64);
  const auto count = dds_get_matched_subscriptions(writer, handles.data(), handles.size());
  std::set<Guid> readers;
  for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(count, 0)); ++i) {
    dds_builtintopic_endpoint_t* found = dds_get_matched_subscription_data(writer, handles[i]);
    if (found == nullptr) continue;
    Guid guid{};
    std::copy_n(found->key.v, guid.size(), guid.begin());
    readers.insert(guid);
    dds_builtintopic_free_endpoint(found);
  }
  return readers;
}

TEST(Compatibility, IsWhatTheMiddlewareMatches) {
  const Side writers("writer", dds_create_writer);
  const Side readers("reader", dds_create_reader);
  Participant onlooker(test_options("onlooker"));
  Discovery discovery(onlooker);
  const std::size_t all = 2 * oddnesses().size();
  ASSERT_TRUE(eventually([&] {
    discovery.update();
    return discovery.endpoints().size() == all;
  }));

  std::map<Guid, DiscoveredEndpoint> announced;
  for (const auto& endpoint : discovery.endpoints()) announced[endpoint.guid] = endpoint;
  std::size_t matches = 0;
  for (const Entity& writer : writers.endpoints()) {
    const auto& offered = announced.at(guid_of(writer.handle()));
    std::set<Guid> expected;
    for (const auto& [guid, endpoint] : announced) {
      if (endpoint.kind == EndpointKind::kReader &&
          mismatches(*offered.qos, *endpoint.qos).empty()) {
        expected.insert(guid);
      }
    }
    EXPECT_TRUE(eventually([&] { return matched_readers(writer.handle()) == expected; }))
        << "writer " << &writer - writers.endpoints().data();
    matches += expected.size();
  }
  // Both kinds are there, or the test says nothing.
  EXPECT_GT(matches, all);
  EXPECT_LT(matches, oddnesses().size() * oddnesses().size() - all);
}

TEST(Compatibility, NamesPolicyAndBothValues) {
  const Qos offered(dds_create_qos());
  const Qos asked(dds_create_qos());
  dds_qset_reliability(offered.get(), DDS_RELIABILITY_BEST_EFFORT, 0);
  dds_qset_reliability(asked.get(), DDS_RELIABILITY_RELIABLE, 0);
  dds_qset_deadline(asked.get(), DDS_MSECS(20));
  const auto found = mismatches(*offered, *asked);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].policy, "reliability");
  EXPECT_EQ(found[0].offered, "best-effort");
  EXPECT_EQ(found[0].asked, "reliable");
  EXPECT_EQ(found[1].policy, "deadline");
  EXPECT_EQ(found[1].offered, "infinite");
  EXPECT_EQ(found[1].asked, "20 ms");
}

}  // namespace
}  // namespace scarab::bus
