/// Another vendor's DDS reads every topic of a running stack; held against what the logger
/// recorded.
#include <algorithm>
#include <map>
#include <sstream>

#include "common/mcap/reader.hpp"
#include "common/sample/idl_parser.hpp"
#include "common/sample/sample_text.hpp"
#include "tests/interop/bystander.hpp"
#include "tests/interop/fastdds/fixture.hpp"
#include "tests/support/eventually.hpp"

namespace scarab::test {
namespace {

using testing::Contains;
using testing::Ge;
using testing::HasSubstr;
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
  std::map<std::uint16_t, sample::TypeModel> types;
  for (const auto& [id, schema] : reader.summary().schemas) {
    types.emplace(id, sample::parse_idl({schema.data.begin(), schema.data.end()}, schema.name));
  }
  reader.for_each([&](const mcap::Channel& channel, const mcap::Message& message) {
    const auto* bytes = reinterpret_cast<const std::byte*>(message.data.data());
    add(values, channel.topic,
        sample::json_text(types.at(channel.schema_id), {bytes, message.data.size()}));
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

/// A sample of service_status that was superseded before it arrived may be missing, on either side:
/// its profile keeps one. What both have is the same. (Fast DDS 2.9.1 hands over samples of a keyed
/// topic in another order at times, on a loaded machine.)
void expect_equal_where_both_have_it(const std::vector<std::string>& ours,
                                     const std::vector<std::string>& theirs) {
  std::map<std::string, std::string> by_stamp;
  for (const std::string& value : ours) by_stamp[field(value, "stamp_ns")] = value;
  int common = 0;
  for (const std::string& value : theirs) {
    const auto same = by_stamp.find(field(value, "stamp_ns"));
    if (same == by_stamp.end()) continue;
    EXPECT_EQ(same->second, value);
    ++common;
  }
  EXPECT_GE(common, 2) << "of " << ours.size() << " and " << theirs.size() << " samples";
}

std::string newest(const std::vector<std::string>& values) {
  return *std::max_element(values.begin(), values.end(), [](const auto& a, const auto& b) {
    return std::stoll(field(a, "stamp_ns")) < std::stoll(field(b, "stamp_ns"));
  });
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
      expect_equal_where_both_have_it(values, found->second);
    } else {
      EXPECT_EQ(values.size(), found->second.size());
      EXPECT_EQ(values, found->second);
    }
  }
  bus::for_each_topic([&](const auto& topic) {
    if (topic.name == kStatus) return;
    EXPECT_THAT(ours, Contains(Pair(topic.name, SizeIs(Ge(1U)))));
  });
  // The last word of who has ended is what a keyed reader is left with.
  for (const char* service : {R"("plant"0)", R"("supervisor"0)", R"("premotor"0)"}) {
    SCOPED_TRACE(service);
    const std::string key = kStatus + " of " + service;
    EXPECT_THAT(newest(theirs.at(key)), HasSubstr("LIFECYCLE_FINALISED"));
    EXPECT_EQ(newest(ours.at(key)), newest(theirs.at(key)));
  }
  EXPECT_THAT(ours.at("scarab/robot_state"), SizeIs(Ge(150U)));
}

}  // namespace
}  // namespace scarab::test
