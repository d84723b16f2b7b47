/// Another vendor's DDS reads every topic of a running stack; held against what the logger
/// recorded.
#include <map>
#include <sstream>

#include "common/bus/idl_parser.hpp"
#include "common/bus/sample_text.hpp"
#include "common/mcap/reader.hpp"
#include "tests/interop/bystander.hpp"
#include "tests/interop/fastdds/fixture.hpp"
#include "tests/support/eventually.hpp"

namespace scarab::test {
namespace {

using testing::Contains;
using testing::Ge;
using testing::Pair;
using testing::SizeIs;

/// The samples of each topic as JSON, in order; those of service_status by service.
using Values = std::map<std::string, std::vector<std::string>>;

const std::string kStatus = "scarab/service_status";

/// What follows `"name": ` up to the next comma; empty where there is no such name.
std::string field(const std::string& json, const std::string& name) {
  const std::string key = "\"" + name + "\": ";
  const auto at = json.find(key);
  if (at == std::string::npos) return {};
  const auto begin = at + key.size();
  return json.substr(begin, json.find_first_of(",}", begin) - begin);
}

void add(Values& values, const std::string& topic, const std::string& json) {
  const bool keyed = topic == kStatus;
  const std::string key = keyed ? " of " + field(json, "service") + field(json, "instance") : "";
  values[topic + key].push_back(json);
}

Values recorded(const std::filesystem::path& log) {
  Values values;
  const mcap::Reader reader(log);
  std::map<std::uint16_t, bus::TypeModel> types;
  for (const auto& [id, schema] : reader.summary().schemas) {
    types.emplace(id, bus::parse_idl({schema.data.begin(), schema.data.end()}, schema.name));
  }
  reader.for_each([&](const mcap::Channel& channel, const mcap::Message& message) {
    const auto* bytes = reinterpret_cast<const std::byte*>(message.data.data());
    add(values, channel.topic,
        bus::json_text(types.at(channel.schema_id), {bytes, message.data.size()}));
  });
  return values;
}

Values echoed(const std::string& output) {
  Values values;
  std::istringstream lines(output);
  const std::string begin = R"({"topic":")";
  const std::string middle = R"(","value":)";
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find(middle);
    if (line.compare(0, begin.size(), begin) != 0 || at == std::string::npos) {
      ADD_FAILURE() << "not a sample: " << line;
      continue;
    }
    const auto value = at + middle.size();
    add(values, line.substr(begin.size(), at - begin.size()),
        line.substr(value, line.size() - value - 1));
  }
  return values;
}

/// The part of `values` stamped within [first, last].
std::vector<std::string> between(const std::vector<std::string>& values, std::int64_t first,
                                 std::int64_t last) {
  std::vector<std::string> part;
  for (const std::string& value : values) {
    const std::int64_t stamp = std::stoll(field(value, "stamp_ns"));
    if (stamp >= first && stamp <= last) part.push_back(value);
  }
  return part;
}

/// Equal from when both had matched the writer until one of them stopped.
void expect_equal_while_both_listened(const std::string& topic,
                                      const std::vector<std::string>& ours,
                                      const std::vector<std::string>& theirs) {
  ASSERT_THAT(ours, SizeIs(Ge(2U))) << topic;
  ASSERT_THAT(theirs, SizeIs(Ge(2U))) << topic;
  const auto stamp = [](const std::string& value) { return std::stoll(field(value, "stamp_ns")); };
  const std::int64_t first = std::max(stamp(ours.front()), stamp(theirs.front()));
  const std::int64_t last = std::min(stamp(ours.back()), stamp(theirs.back()));
  EXPECT_THAT(between(ours, first, last), SizeIs(Ge(2U))) << topic;
  EXPECT_EQ(between(ours, first, last), between(theirs, first, last)) << topic;
}

using FastDdsEcho = FastDdsTest;

TEST_F(FastDdsEcho, ReadsEverySampleOfEveryTopicAsTheLoggerRecordsIt) {
  Stack::Options options = on_this_domain();
  options.witness = true;  // the echo, as logger/1
  Stack stack(directory_ / "run", options);
  const auto echo = start_foreign("fastdds-echo", stack, {"--instance", "1"});
  const Bystander bystander(claim_);
  auto experiment = stack.conduct(main_trial());
  EXPECT_EQ(experiment.wait(kTrialLimit), 0)
      << experiment.output() << stack.errors() << echo->output();
  ASSERT_TRUE(stack.stop()) << stack.errors();
  EXPECT_EQ(echo->stop(), 0) << echo->err();

  const Values ours = recorded(stack.log());
  const Values theirs = echoed(echo->out());
  for (const auto& [topic, values] : ours) {
    SCOPED_TRACE(topic);
    const auto found = theirs.find(topic);
    ASSERT_NE(found, theirs.end());
    if (topic.compare(0, kStatus.size(), kStatus) == 0) {
      expect_equal_while_both_listened(topic, values, found->second);
    } else {
      EXPECT_EQ(values.size(), found->second.size());
      EXPECT_EQ(values, found->second);
    }
  }
  bus::for_each_topic([&](const auto& topic) {
    if (topic.name == kStatus) return;
    EXPECT_THAT(ours, Contains(Pair(topic.name, SizeIs(Ge(1U)))));
  });
  for (const char* service :
       {R"("plant"0)", R"("supervisor"0)", R"("premotor"0)", R"("logger"0)"}) {
    EXPECT_THAT(theirs, Contains(Pair(kStatus + " of " + service, SizeIs(Ge(2U)))));
  }
  EXPECT_THAT(ours.at("scarab/robot_state"), SizeIs(Ge(150U)));
}

}  // namespace
}  // namespace scarab::test
