// Every type a user may meet, discovered over the wire by a participant that was not compiled with
// it.
#include <gmock/gmock.h>
#include <wire_types.h>

#include <algorithm>

#include "common/bus/discovery.hpp"
#include "common/bus/dynamic_sample.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/raw_reader.hpp"
#include "common/bus/raw_writer.hpp"
#include "common/bus/stored_type.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/cdr_builder.hpp"
#include "common/sample/idl_parser.hpp"
#include "common/sample/idl_text.hpp"
#include "common/sample/sample_text.hpp"
#include "tests/integration/types/any_endpoint.hpp"
#include "tests/integration/types/sample_filler.hpp"
#include "tests/ros_idl/ros_types.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

using std::chrono::seconds;

std::vector<const dds_topic_descriptor_t*> all_types() {
  std::vector<const dds_topic_descriptor_t*> out = ros_types();
  for (const std::string& name : bus::known_type_names()) out.push_back(bus::find_known_type(name));
  for (const auto* type : {&wire_Everything_desc, &wire_KeyedByParts_desc, &wire_Derived_desc}) {
    out.push_back(type);
  }
  return out;
}

/// Those that are written in XCDR2 only.
std::vector<const dds_topic_descriptor_t*> growing_types() {
  return {&wire_Growing_desc, &wire_Carrier_desc, &wire_Step_desc};
}

std::vector<const dds_topic_descriptor_t*> all_and_growing_types() {
  auto out = all_types();
  for (const auto* type : growing_types()) out.push_back(type);
  return out;
}

std::string test_name(const testing::TestParamInfo<const dds_topic_descriptor_t*>& type) {
  std::string name = type.param->m_typename;
  std::replace(name.begin(), name.end(), ':', '_');
  return name;
}

bus::RawQos in_xcdr2() {
  bus::RawQos qos = kept();
  qos.xcdr2 = true;
  return qos;
}

struct WireType : testing::TestWithParam<const dds_topic_descriptor_t*> {
  const dds_topic_descriptor_t& compiled = *GetParam();
  bus::Participant typed{test_options("typed")};
  bus::Participant typeless{test_options("typeless")};
  bus::Discovery discovery{typeless};

  /// A typed writer's sample, read by who has discovered the type, has every leaf.
  void expect_decoded(const bus::RawQos& qos) {
    AnyWriter writer(typed, "rt/topic", compiled, qos);
    const bus::DiscoveredEndpoint found = discover(discovery, "rt/topic");
    ASSERT_EQ(found.type, compiled.m_typename);
    const bus::TopicType type = discovery.type_of(found, seconds(10));
    bus::RawReader reader(typeless, {found}, type);
    const FilledSample sample(compiled);
    writer.write(sample.get());
    const std::vector<Taken> taken = take_some(reader, 1);
    ASSERT_EQ(taken.size(), 1U);
    const sample::Bytes& cdr = taken[0].cdr;

    const sample::TypeModel model = bus::model_of(*type);
    EXPECT_EQ(sample::json_text(model, cdr), sample.json());
    const sample::TypeModel parsed = sample::parse_idl(sample::idl_text(model), model.name());
    EXPECT_EQ(sample::json_text(parsed, cdr), sample.json());
    // Through the C struct of the discovered type and back: the bytes of the compiled one.
    EXPECT_EQ(bus::encode_sample(*type, bus::DynamicSample(type, cdr).get()),
              bus::encode_sample(compiled, sample.get()));
  }

  /// What a participant that was never told the type writes reaches a typed reader.
  void expect_written_again(const bus::RawQos& qos) {
    const bus::StoredType stored = bus::store_type(compiled);
    bus::RawWriter writer(typeless, "rt/topic", bus::restore_type(typeless, stored), qos);
    AnyReader reader(typed, "rt/topic", compiled, qos);
    const FilledSample sample(compiled);
    const sample::Bytes cdr = bus::encode_sample(compiled, sample.get());
    writer.write(cdr, 1'234'567'890);
    const std::vector<Taken> taken = take_some(reader, 1);
    ASSERT_EQ(taken.size(), 1U);
    EXPECT_EQ(taken[0].cdr, cdr);
    EXPECT_EQ(taken[0].source_ns, 1'234'567'890);
  }
};

TEST_P(WireType, IsDecodedToTheLastLeaf) { expect_decoded(kept()); }
TEST_P(WireType, IsWrittenAgainByWhoNeverKnewIt) { expect_written_again(kept()); }
INSTANTIATE_TEST_SUITE_P(, WireType, testing::ValuesIn(all_types()), test_name);

struct WireTypeInXcdr2 : WireType {};
TEST_P(WireTypeInXcdr2, IsDecodedToTheLastLeaf) { expect_decoded(in_xcdr2()); }
INSTANTIATE_TEST_SUITE_P(, WireTypeInXcdr2, testing::ValuesIn(all_and_growing_types()), test_name);

struct GrowingWireType : WireType {};
TEST_P(GrowingWireType, IsWrittenAgainByWhoNeverKnewIt) { expect_written_again(in_xcdr2()); }

TEST_P(GrowingWireType, IsBuiltAsCyclonePutsIt) {
  const auto type = bus::borrow_compiled(compiled);
  const sample::Bytes built = sample::build_cdr(bus::model_of(compiled), {}, 0);
  EXPECT_EQ(bus::encode_sample(compiled, bus::DynamicSample(type, built).get()), built);
}

INSTANTIATE_TEST_SUITE_P(, GrowingWireType, testing::ValuesIn(growing_types()), test_name);

}  // namespace
}  // namespace scarab::test
