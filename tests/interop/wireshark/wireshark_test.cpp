/// Wireshark's RTPS dissector names the topics and types of a stack it has never heard of.
#include <gmock/gmock.h>

#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "tests/interop/bystander.hpp"
#include "tests/interop/wireshark/capture.hpp"
#include "tests/support/files.hpp"
#include "tests/system/stack.hpp"

namespace scarab::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Topic and type.
using Named = std::set<std::pair<std::string, std::string>>;

const std::string kAnnouncedWriters = "rtps.sm.wrEntityId == 0x000003c2";
const std::string kAnnouncedReaders = "rtps.sm.wrEntityId == 0x000004c2";
const std::string kSamples = "rtps.issueData && !(rtps.sm.wrEntityId == 0x000100c2)";

/// Those of a packet's lists `topic,topic<tab>type,type`.
void add(Named& named, const std::string& line) {
  std::istringstream topics(line.substr(0, line.find('\t')));
  std::istringstream types(line.substr(line.find('\t') + 1));
  std::string topic;
  std::string type;
  while (std::getline(topics, topic, ',') && std::getline(types, type, ',')) {
    named.emplace(topic, type);
  }
}

Named named_in(const Capture& capture, const std::string& filter) {
  Named named;
  for (const auto& line :
       capture.dissect(filter, {"rtps.param.topicName", "rtps.param.typeName"})) {
    add(named, line);
  }
  return named;
}

/// All topics of the stack.
Named the_stacks() {
  Named named;
  bus::for_each_topic([&](const auto& topic) {
    using Sample = typename std::decay_t<decltype(topic)>::Type;
    named.emplace(topic.name, bus::descriptor<Sample>().m_typename);
  });
  return named;
}

TEST(Wireshark, NamesEveryTopicAndItsTypeInDiscoveryAndInEachSample) {
  const DomainClaim claim;
  const TemporaryDirectory directory;
  std::optional<Capture> capture;
  ASSERT_NO_THROW(capture.emplace(claim.domain(), directory / "lo.pcapng"));
  Stack::Options options;
  options.host = options.plant_host = claim.host();
  Stack stack(directory / "run", options);
  Bystander bystander(claim);
  auto experiment = stack.conduct(main_trial());
  EXPECT_EQ(experiment.wait(std::chrono::seconds(30)), 0) << experiment.output();
  EXPECT_TRUE(stack.stop()) << stack.errors();
  capture->stop();

  const Named writers = named_in(*capture, kAnnouncedWriters);
  const Named readers = named_in(*capture, kAnnouncedReaders);
  const Named samples = named_in(*capture, kSamples);
  const auto lines = capture->dissect(kSamples, {"_ws.col.Info"});
  for (const auto& topic : the_stacks()) {
    EXPECT_THAT(writers, Contains(topic));
    EXPECT_THAT(readers, Contains(topic));
    EXPECT_THAT(samples, Contains(topic));
    EXPECT_THAT(lines, Contains(HasSubstr("DATA -> " + topic.first))) << "what a person reads";
  }
}

}  // namespace
}  // namespace scarab::test
