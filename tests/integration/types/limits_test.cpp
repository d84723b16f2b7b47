// What cannot be decoded: it must be said clearly, and must not keep the topic from being recorded.
#include <gmock/gmock.h>
#include <wire_types.h>

#include "common/bus/discovery.hpp"
#include "common/bus/error.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/raw_reader.hpp"
#include "common/bus/raw_writer.hpp"
#include "common/bus/stored_type.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/sample_text.hpp"
#include "common/sample/type_model.hpp"
#include "tests/integration/types/any_endpoint.hpp"
#include "tests/integration/types/sample_filler.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

struct Limit {
  const dds_topic_descriptor_t* type;
  const char* error;
};
void PrintTo(const Limit& limit, std::ostream* out) { *out << limit.type->m_typename; }

struct Undecodable : testing::TestWithParam<Limit> {};

TEST_P(Undecodable, IsAnErrorThatNamesTheConstruct) {
  const dds_topic_descriptor_t& type = *GetParam().type;
  EXPECT_THAT([&] { bus::model_of(type); }, ThrowsMessage<bus::Error>(StrEq(GetParam().error)));
}

const Limit kLimits[] = {
    {&wire_WithUnion_desc, "type wire::WithUnion: union wire::Choice not supported"},
    {&wire_WithBitmask_desc, "type wire::WithBitmask: bitmask wire::Marks not supported"},
    {&wire_WithOptional_desc, "type wire::WithOptional: optional member maybe not supported"},
    {&wire_WithSmallEnum_desc,
     "type wire::WithSmallEnum: enum wire::Small of 8 bits not supported"},
    {&wire_WithAll_desc, "type wire::WithAll: union wire::Nested not supported"},
    {&wire_WithNumbers_desc,
     "type wire::WithNumbers: mutable struct wire::WithNumbers not supported"},
};
INSTANTIATE_TEST_SUITE_P(, Undecodable, testing::ValuesIn(kLimits), [](const auto& limit) {
  return std::string(limit.param.type->m_typename).substr(6);
});

struct Unusual : testing::Test {
  bus::Participant foreign{test_options("")};
  bus::Participant logger{test_options("logger")};
  bus::Discovery discovery{logger};
};

/// A type as Fast DDS announces it: by its name.
dds_topic_descriptor_t without_information(const dds_topic_descriptor_t& from) {
  const std::uint32_t flags = from.m_flagset & ~std::uint32_t{DDS_TOPIC_XTYPES_METADATA};
  return {from.m_size,     from.m_align, flags,       from.m_nkeys,
          from.m_typename, from.m_keys,  from.m_nops, from.m_ops,
          from.m_meta,     {},           {},          0};
}

TEST_F(Unusual, SilentWriterOfAForeignTypeIsReportedAsSuch) {
  const auto type = without_information(wire_Single_desc);
  AnyWriter writer(foreign, "wire/single", type);
  const bus::DiscoveredEndpoint found = discover(discovery, "wire/single");
  EXPECT_EQ(found.type, "wire::Single");
  EXPECT_THAT([&] { discovery.type_of(found, seconds(10)); },
              ThrowsMessage<bus::Error>(
                  StrEq("type wire::Single of wire/single: its writer sends no type information, "
                        "and it is none of Scarab's own")));
}

TEST_F(Unusual, SilentWriterOfAKnownTypeIsRead) {
  for (const std::string& name : bus::known_type_names()) {
    SCOPED_TRACE(name);
    const dds_topic_descriptor_t& compiled = *bus::find_known_type(name);
    const auto silent = without_information(compiled);
    const std::string topic = "somewhere/" + name.substr(8);
    AnyWriter writer(foreign, topic, silent);
    const bus::DiscoveredEndpoint found = discover(discovery, topic);
    const bus::TopicType type = discovery.type_of(found, seconds(10));
    bus::RawReader reader(logger, {found}, type);
    const FilledSample sample(compiled);
    writer.write(sample.get());
    const std::vector<Taken> taken = take_some(reader, 1);
    ASSERT_EQ(taken.size(), 1U);
    EXPECT_EQ(sample::json_text(bus::model_of(*type), taken[0].cdr), sample.json());
  }
}

TEST_F(Unusual, KeysThatCycloneCannotTakeAreSaid) {
  for (const auto* type :
       {&wire_KeyedInBase_desc, &wire_DerivedKeys_desc, &wire_KeyedByBoundedText_desc}) {
    const std::string topic = std::string("wire/") + (type->m_typename + 6);
    AnyWriter writer(foreign, topic, *type);
    const bus::DiscoveredEndpoint found = discover(discovery, topic);
    EXPECT_THAT([&] { discovery.type_of(found, seconds(10)); },
                ThrowsMessage<bus::Error>(HasSubstr("Cyclone DDS cannot read such types")));
    EXPECT_THAT([&] { bus::restore_type(logger, bus::store_type(*type)); },
                ThrowsMessage<bus::Error>(HasSubstr("cannot be restored")));
  }
}

TEST_F(Unusual, UndecodableTypesAreStillRecordedAndPublishedAgain) {
  for (const Limit& limit : kLimits) {
    const dds_topic_descriptor_t& compiled = *limit.type;
    SCOPED_TRACE(compiled.m_typename);
    const std::string topic = std::string("wire/") + (compiled.m_typename + 6);
    bus::RawQos qos = kept();
    qos.xcdr2 = true;
    AnyWriter original(foreign, topic, compiled, qos);
    const bus::DiscoveredEndpoint found = discover(discovery, topic);
    const bus::TopicType type = discovery.type_of(found, seconds(10));
    bus::RawReader recorder(logger, {found}, type);
    const std::vector<std::byte> zero(compiled.m_size);
    original.write(zero.data());
    const std::vector<Taken> recorded = take_some(recorder, 1);
    ASSERT_EQ(recorded.size(), 1U);

    bus::RawWriter again(logger, topic + "/again",
                         bus::restore_type(logger, bus::store_type(*type)), qos);
    AnyReader reader(foreign, topic + "/again", compiled, qos);
    again.write(recorded[0].cdr);
    const std::vector<Taken> taken = take_some(reader, 1);
    ASSERT_EQ(taken.size(), 1U);
    EXPECT_EQ(taken[0].cdr, recorded[0].cdr);
  }
}

}  // namespace
}  // namespace scarab::test
