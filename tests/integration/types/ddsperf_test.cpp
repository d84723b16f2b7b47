// Cyclone's own performance tool, as an example of a program that knows nothing of this project.
#include <gmock/gmock.h>

#include "common/bus/discovery.hpp"
#include "common/bus/domain_config.hpp"
#include "common/bus/dynamic_sample.hpp"
#include "common/bus/raw_reader.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/idl_parser.hpp"
#include "common/sample/idl_text.hpp"
#include "common/sample/sample_text.hpp"
#include "common/sample/sample_tree.hpp"
#include "tests/integration/types/any_endpoint.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/files.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

using std::chrono::seconds;
using testing::AllOf;
using testing::HasSubstr;

struct Published {
  const char* option;  ///< of ddsperf's -T
  const char* type;
  std::size_t members;
};
void PrintTo(const Published& published, std::ostream* out) { *out << published.option; }

struct Ddsperf : testing::TestWithParam<Published> {
  TemporaryDirectory directory;
  const bus::ParticipantOptions options = test_options("typeless");
  ChildProcess program = start();
  bus::Participant typeless{options};
  bus::Discovery discovery{typeless};

  ChildProcess start() const {
    const std::string uri = "CYCLONEDDS_URI=" + bus::domain_config(options, std::nullopt);
    return {{"/usr/bin/env", uri, "ddsperf", "-T", GetParam().option, "pub", "200Hz"},
            directory / "ddsperf"};
  }

  bus::DiscoveredEndpoint writer_on(const std::string& prefix) {
    bus::DiscoveredEndpoint found;
    EXPECT_TRUE(eventually([&] {
      for (const auto& endpoint : discovery.update()) {
        const bool is_it = endpoint.topic.compare(0, prefix.size(), prefix) == 0;
        if (is_it && endpoint.kind == bus::EndpointKind::kWriter) found = endpoint;
      }
      return !found.topic.empty();
    })) << program.output();
    return found;
  }

  /// Samples of a topic, each decoded and encoded again on the way.
  std::vector<sample::Bytes> take(const bus::DiscoveredEndpoint& writer, const bus::TopicType& type,
                                  std::size_t count) {
    bus::RawReader reader(typeless, {writer}, type);
    std::vector<sample::Bytes> out;
    for (Taken& taken : take_some(reader, count)) {
      EXPECT_EQ(bus::encode_sample(*type, bus::DynamicSample(type, taken.cdr).get()), taken.cdr);
      out.push_back(std::move(taken.cdr));
    }
    return out;
  }
};

std::uint64_t member(const sample::SampleNode& sample, const std::string& name) {
  for (const auto& [key, node] : std::get<sample::SampleNode::Struct>(sample.value)) {
    if (key == name) return std::get<std::uint64_t>(std::get<sample::Scalar>(node.value));
  }
  throw std::out_of_range(name);
}

TEST_P(Ddsperf, PublishesWhatTypelessToolsRead) {
  const bus::DiscoveredEndpoint writer = writer_on("DDSPerfRData");
  EXPECT_EQ(writer.type, GetParam().type);
  const bus::TopicType type = discovery.type_of(writer, seconds(10));
  const sample::TypeModel model = bus::model_of(*type);
  EXPECT_EQ(model.root().members.size(), GetParam().members);
  const sample::TypeModel parsed = sample::parse_idl(sample::idl_text(model), model.name());
  const std::vector<sample::Bytes> samples = take(writer, type, 3);
  ASSERT_GE(samples.size(), 3U);
  std::uint64_t last = member(sample::sample_tree(model, samples[0]), "seq");
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_EQ(member(sample::sample_tree(model, samples[i]), "seq"), ++last);
    EXPECT_EQ(sample::json_text(parsed, samples[i]), sample::json_text(model, samples[i]));
  }
}

constexpr Published kPublished[] = {
    {"KS", "KeyedSeq", 3},     {"K32", "Keyed32", 3},     {"K256", "Keyed256", 3},
    {"OU", "OneULong", 1},     {"UK16", "Unkeyed16", 2},  {"UK1024", "Unkeyed1024", 2},
    {"S16", "Struct16", 19},   {"S256", "Struct256", 19}, {"S4k", "Struct4k", 19},
    {"S32k", "Struct32k", 11},
};
INSTANTIATE_TEST_SUITE_P(, Ddsperf, testing::ValuesIn(kPublished),
                         [](const auto& topic) { return topic.param.option; });

struct DdsperfItself : Ddsperf {};

TEST_P(DdsperfItself, TellsOfItsLoad) {
  const bus::DiscoveredEndpoint writer = writer_on("DDSPerfCPUStats");
  const bus::TopicType type = discovery.type_of(writer, seconds(10));
  const std::vector<sample::Bytes> samples = take(writer, type, 1);
  ASSERT_GE(samples.size(), 1U);
  const std::string json = sample::json_text(bus::model_of(*type), samples[0]);
  // How many threads it lists depends on their load.
  EXPECT_THAT(json, AllOf(HasSubstr("\"hostname\": \""),
                          HasSubstr("\"pid\": " + std::to_string(program.pid()) + ","),
                          HasSubstr("\"some_above\": "), HasSubstr("\"cpu\": [")));
}

INSTANTIATE_TEST_SUITE_P(, DdsperfItself, testing::Values(kPublished[0]),
                         [](const auto& topic) { return topic.param.option; });

}  // namespace
}  // namespace scarab::test
