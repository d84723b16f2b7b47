#include "common/bus/stored_type.hpp"

#include <gmock/gmock.h>
#include <wire_types.h>

#include "common/bus/error.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/idl_text.hpp"
#include "common/sample/type_model.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

struct StoredType : testing::Test {
  bus::Participant participant{test_options("replay")};
  const bus::StoredType stored = bus::store_type(wire_Everything_desc);
};

TEST_F(StoredType, IsRestoredWhole) {
  const bus::TopicType type = bus::restore_type(participant, stored);
  EXPECT_STREQ(type->m_typename, "wire::Everything");
  EXPECT_EQ(type->m_size, wire_Everything_desc.m_size);
  EXPECT_EQ(type->m_nkeys, wire_Everything_desc.m_nkeys);
  EXPECT_EQ(sample::idl_text(bus::model_of(*type)),
            sample::idl_text(bus::model_of(wire_Everything_desc)));
  const bus::StoredType again = bus::store_type(*type);
  EXPECT_EQ(again.name, stored.name);
  EXPECT_EQ(again.information.size(), stored.information.size());  // its parts in another order
}

TEST_F(StoredType, OutlivesTheParticipantAndIsRestoredAgain) {
  bus::TopicType type;
  {
    bus::Participant other(test_options("other"));
    type = bus::restore_type(other, stored);
    EXPECT_EQ(bus::restore_type(other, stored)->m_size, type->m_size);
    bus::restore_type(other, bus::store_type(wire_Single_desc));
  }
  const bus::TopicType second = bus::restore_type(participant, bus::store_type(*type));
  EXPECT_EQ(second->m_size, wire_Everything_desc.m_size);
}

TEST_F(StoredType, WithoutInformationIsAnErrorThatNamesTheType) {
  const dds_topic_descriptor_t& from = wire_Single_desc;
  const dds_topic_descriptor_t silent{from.m_size,     from.m_align, 0,           from.m_nkeys,
                                      from.m_typename, from.m_keys,  from.m_nops, from.m_ops,
                                      from.m_meta,     {},           {},          0};
  EXPECT_THAT([&] { bus::store_type(silent); },
              ThrowsMessage<bus::Error>(HasSubstr("wire::Single: no type information")));
  EXPECT_THAT(
      [&] {
        bus::restore_type(participant, {"wire::Single", {}, {}});
      },
      ThrowsMessage<bus::Error>(HasSubstr("type wire::Single")));
}

TEST_F(StoredType, OfAnotherTypesMappingIsAnError) {
  bus::StoredType mixed = bus::store_type(wire_Single_desc);
  mixed.mapping = stored.mapping;
  EXPECT_THAT([&] { bus::restore_type(participant, mixed); },
              ThrowsMessage<bus::Error>(HasSubstr("type wire::Single")));
}

TEST_F(StoredType, DamagedAnywhereIsAnErrorOrAType) {
  std::size_t refused = 0;
  const auto try_out = [&](const bus::StoredType& damaged) {
    try {
      bus::restore_type(participant, damaged);
    } catch (const bus::Error&) {
      ++refused;
    }
  };
  for (sample::Bytes bus::StoredType::*part :
       {&bus::StoredType::information, &bus::StoredType::mapping}) {
    for (std::size_t i = 0; i < (stored.*part).size(); i += 3) {
      bus::StoredType damaged = stored;
      (damaged.*part)[i] ^= static_cast<std::byte>(1U + i % 255);
      try_out(damaged);
      (damaged.*part).resize(i);
      try_out(damaged);
    }
  }
  EXPECT_GT(refused, 0U);
}

}  // namespace
}  // namespace scarab::test
