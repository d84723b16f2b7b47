// Topics of a type that the project was not compiled with.
#include <foreign.h>
#include <gmock/gmock.h>

#include "common/bus/raw_reader.hpp"
#include "common/bus/topic_type.hpp"
#include "common/bus/waitset.hpp"
#include "common/sample/idl_text.hpp"
#include "common/sample/sample_columns.hpp"
#include "common/sample/sample_text.hpp"
#include "tests/integration/bus/fixture.hpp"

namespace scarab::bus {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A foreign participant, on Cyclone's own API, without user data.
class ForeignWriter {
 public:
  ForeignWriter(const Participant& host, const dds_topic_descriptor_t& type, const char* name)
      : topic_(dds_create_topic(host.handle(), &type, name, nullptr, nullptr)) {
    const Qos qos(dds_create_qos());
    const char* partition = "elsewhere";
    dds_qset_durability(qos.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_partition(qos.get(), 1, &partition);
    writer_ = Entity(dds_create_writer(host.handle(), topic_.handle(), qos.get(), nullptr));
  }
  void write(const void* sample) { ASSERT_EQ(dds_write(writer_.handle(), sample), 0); }

 private:
  Entity topic_;
  Entity writer_;
};

somebody_inner_Everything everything() {
  static double numbers[] = {0.5, 1e300};
  static char hello[] = "hello";
  somebody_inner_Everything s{};
  s.id = -3;
  s.flag = true;
  s.raw = 200;
  s.letter = 'x';
  s.small = -2;
  s.ularge = 18446744073709551615U;
  s.paint = somebody_inner_GREEN;
  s.colours[1] = somebody_inner_BLUE;
  s.weights[1][2] = 6.25;
  s.name = hello;
  s.tag[0] = 'T';
  s.corners[1].y = 2.5F;
  s.numbers._buffer = numbers;
  s.numbers._length = s.numbers._maximum = 2;
  return s;
}

struct Foreign : testing::Test {
  Participant stranger{test_options("")};
  Participant logger{test_options("logger")};
  Discovery discovery{logger};

  DiscoveredEndpoint discover(const std::string& topic) {
    DiscoveredEndpoint found;
    EXPECT_TRUE(eventually([&] {
      for (const DiscoveredEndpoint& endpoint : discovery.update()) {
        if (endpoint.topic == topic) found = endpoint;
      }
      return !found.topic.empty();
    }));
    return found;
  }
};

TEST_F(Foreign, ATypeNobodyKnowsIsReadAndPrinted) {
  ForeignWriter writer(stranger, somebody_inner_Everything_desc, "somebody/topic");
  const DiscoveredEndpoint found = discover("somebody/topic");
  EXPECT_EQ(found.type, "somebody::inner::Everything");
  const TopicType type = discovery.type_of(found, seconds(10));
  const sample::TypeModel model = bus::model_of(*type);
  const sample::TypeModel compiled = bus::model_of(somebody_inner_Everything_desc);
  EXPECT_EQ(sample::idl_text(model), sample::idl_text(compiled));

  RawReader reader(logger, {found}, type);
  WaitSet waitset(logger);
  waitset.attach(reader);
  const auto sample = everything();
  writer.write(&sample);
  ASSERT_TRUE(waitset.wait(seconds(10)));
  std::string json;
  std::vector<std::string> values;
  reader.take([&](const RawSample& raw) {
    json = sample::json_text(model, raw.cdr);
    values = sample::column_values(model, raw.cdr);
  });
  EXPECT_EQ(json,
            R"({"id": -3, "flag": true, "raw": 200, "letter": "x", "small": -2, "usmall": 0, )"
            R"("medium": 0, "large": 0, "ularge": 18446744073709551615, "paint": "GREEN", )"
            R"("colours": ["RED", "BLUE"], "weights": [[0, 0, 0], [0, 0, 6.25]], "image": [], )"
            R"("name": "hello", "tag": "T", "words": [], "path": [], )"
            R"("corners": [{"x": 0, "y": 0}, {"x": 0, "y": 2.5}], "palette": [], )"
            R"("numbers": [0.5, 1e+300]})");
  EXPECT_EQ(values.size(), sample::column_names(model).size());
}

TEST_F(Foreign, AnEndpointThatGoesLeavesTheList) {
  {
    ForeignWriter writer(stranger, somebody_inner_Everything_desc, "somebody/topic");
    EXPECT_EQ(discover("somebody/topic").peer, Peer{});
    EXPECT_EQ(discovery.endpoints().size(), 1U);
  }
  WaitSet waitset(logger);
  waitset.attach(discovery);
  ASSERT_TRUE(waitset.wait(seconds(10)));
  discovery.update();
  EXPECT_TRUE(discovery.endpoints().empty());
}

TEST_F(Foreign, WithoutTypeInformationTheTopicIsNamed) {
  // As another vendor announces its types: by name alone.
  const dds_topic_descriptor_t& full = somebody_inner_Everything_desc;
  const dds_topic_descriptor_t bare{
      full.m_size,  full.m_align,    full.m_flagset & ~DDS_TOPIC_XTYPES_METADATA,
      full.m_nkeys, full.m_typename, full.m_keys,
      full.m_nops,  full.m_ops,      full.m_meta,
      {nullptr, 0}, {nullptr, 0},    full.restrict_data_representation};
  ForeignWriter writer(stranger, bare, "somebody/topic");
  const DiscoveredEndpoint found = discover("somebody/topic");
  EXPECT_THAT([&] { discovery.type_of(found, seconds(1)); },
              ThrowsMessage<Error>(HasSubstr("somebody/topic: its writer sends no type")));
}

}  // namespace
}  // namespace scarab::bus
