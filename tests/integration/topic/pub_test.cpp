#include <csignal>

#include "common/bus/clock.hpp"
#include "common/bus/known_types.hpp"
#include "common/bus/raw_reader.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/topic_type.hpp"
#include "common/sample/sample_text.hpp"
#include "tests/integration/topic/topic_tool.hpp"
#include "tests/integration/types/sample_filler.hpp"
#include "tests/ros_idl/ros_types.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string json_of(const dds_topic_descriptor_t& type, const sample::Bytes& cdr) {
  return sample::json_text(bus::model_of(type), cdr);
}

struct Pub : TopicTool {
  /// What is in a sample arrives value by value, and byte by byte as a compiled writer writes it.
  void expect_round_trip(const dds_topic_descriptor_t& type) {
    const AnyReader reader(plant_, "a", type);
    const FilledSample sample(type);
    write_text(directory_ / "value.json", sample.json());
    const Finished pub = topic({"pub", "a", "@" + (directory_ / "value.json").string()});
    ASSERT_EQ(pub.exit_code, 0) << type.m_typename << "\n" << pub.err;
    const auto taken = take_some(reader, 1);
    ASSERT_EQ(taken.size(), 1U) << type.m_typename;
    EXPECT_EQ(json_of(type, taken[0].cdr), sample.json());
    EXPECT_EQ(taken[0].cdr, bus::encode_sample(type, sample.get())) << type.m_typename;
  }
};

TEST_F(Pub, EveryTypeOfTheProject) {
  for (const std::string& name : bus::known_type_names()) {
    expect_round_trip(*bus::find_known_type(name));
  }
}

TEST_F(Pub, CommonTypesOfRos) {
  for (const char* name :
       {"sensor_msgs::msg::dds_::JointState_", "geometry_msgs::msg::dds_::Twist_",
        "tf2_msgs::msg::dds_::TFMessage_", "nav_msgs::msg::dds_::Odometry_"}) {
    const auto types = ros_types();
    const auto found = std::find_if(types.begin(), types.end(), [&](const auto* type) {
      return std::string(type->m_typename) == name;
    });
    ASSERT_NE(found, types.end()) << name;
    expect_round_trip(**found);
  }
}

TEST_F(Pub, LeavesOutWhatIsNotSaid) {
  bus::Reader<scarab_Operator> reader(plant_, bus::kOperator);
  const std::int64_t before = bus::now_ns();
  const Finished pub = topic({"pub", "scarab/operator",
                              "{header: {stamp_ns: now}, command: OPERATOR_INPUTS, "
                              "inputs: [0.5, -1, 0, 1e-3]}"});
  EXPECT_EQ(pub.exit_code, 0) << pub.err;
  EXPECT_EQ(pub.out, "published 1 sample to 1 reader: plant/0\n");
  std::optional<scarab_Operator> sample;
  ASSERT_TRUE(eventually([&] {
    reader.take([&](const scarab_Operator& taken) { sample = taken; });
    return sample.has_value();
  }));
  EXPECT_EQ(sample->command, scarab_OPERATOR_INPUTS);
  EXPECT_EQ(sample->mode, scarab_MODE_STOP);
  EXPECT_EQ(sample->inputs[1], -1.0);
  EXPECT_EQ(sample->inputs[3], 1e-3);
  EXPECT_GE(sample->header.stamp_ns, before);
  EXPECT_LE(sample->header.stamp_ns, bus::now_ns());
}

TEST_F(Pub, RefusesValuesBeforeItSendsAnything) {
  const AnyReader reader(plant_, bus::kOperator.name, bus::descriptor<scarab_Operator>());
  const auto refused = [&](const std::string& value, const std::string& reason) {
    expect_refused(2, {"pub", "scarab/operator", value}, reason);
  };
  refused("{comand: OPERATOR_STOP}",
          "value: no member comand in scarab::Operator; it has header, command, mode, inputs, "
          "strategy, reason; did you mean command?");
  refused("{header: {tik: 3}}", "value: header: no member tik");
  refused("{command: OPERATOR_HALT}", "value: command: OPERATOR_HALT is no");
  refused("{header: {tick: -1}}", "header.tick: -1 is no unsigned long (0 to 4294967295)");
  refused("{inputs: [1, 2]}", "value: inputs: 2 elements, but it has 4");
  refused("{strategy: " + std::string(64, 'x') + "}", "strategy: text of 64 bytes, at most 63");
  refused("{command: ", "value:1:");
  refused("{command: OPERATOR_STOP, command: OPERATOR_STEP}", "duplicate key");
  refused("", "value");
  expect_refused(2, {"pub", "scarab/operator", "{}", "--rate", "0"}, "--rate");
  expect_refused(2, {"pub", "scarab/operator", "{}", "--once", "-n", "2"}, "excludes");
  std::size_t taken = 0;
  bus::take_raw(reader.handle(), [&](const bus::RawSample&) { ++taken; });
  EXPECT_EQ(taken, 0U);
}

TEST_F(Pub, WaitsForItsReaders) {
  expect_refused(3, {"pub", "scarab/operator", "{}", "--timeout", "0.4"},
                 "scarab/operator has 0 of 1 readers that were waited for");
  ChildProcess pub =
      start_topic({"pub", "scarab/operator", "{}", "--wait", "2", "--timeout", "20"});
  const AnyReader one(plant_, bus::kOperator.name, bus::descriptor<scarab_Operator>());
  bus::Participant other(test_options("supervisor"));
  const AnyReader two(other, bus::kOperator.name, bus::descriptor<scarab_Operator>());
  EXPECT_EQ(pub.wait(kPatience), 0) << pub.err();
  EXPECT_EQ(pub.out(), "published 1 sample to 2 readers: plant/0, supervisor/0\n");
  EXPECT_EQ(take_some(one, 1).size(), 1U);
  EXPECT_EQ(take_some(two, 1).size(), 1U);
}

TEST_F(Pub, MatchesTheReadersThereAre) {
  bus::RawQos strict = kept();
  strict.ownership = DDS_OWNERSHIP_EXCLUSIVE;
  strict.partitions = {"left*"};
  strict.deadline = std::chrono::seconds(2);
  strict.liveliness_lease = std::chrono::seconds(3);
  const AnyReader reader(plant_, "a", bus::descriptor<scarab_Operator>(), strict);
  const Finished pub = topic({"pub", "a", "{mode: MODE_BOXING}"});
  EXPECT_EQ(pub.exit_code, 0) << pub.err;
  EXPECT_EQ(take_some(reader, 1).size(), 1U);
}

TEST_F(Pub, SaysWhyAReaderDoesNotMatch) {
  const AnyReader reader(plant_, "a", bus::descriptor<scarab_Operator>());
  expect_refused(3, {"pub", "a", "{}", "--type", "scarab::Trial", "--timeout", "0.6"},
                 "0 of 1 readers of a have matched within 0.6 s; inconsistent type on a");
}

TEST_F(Pub, NeedsAType) {
  expect_refused(4, {"pub", "b", "{}", "--timeout", "0.3"}, "no topic b in domain 0");
  expect_refused(5, {"pub", "b", "{}", "--type", "scarab::Trail", "--timeout", "0.3"},
                 "did you mean scarab::Trial?");
  EXPECT_EQ(topic({"pub", "b", "{}", "--type", "scarab::Trial", "--wait", "0"}).exit_code, 0);
}

TEST_F(Pub, SendsEveryValueOfAFileAndAtARate) {
  const AnyReader reader(plant_, "a", bus::descriptor<scarab_JointCommand>());
  write_text(directory_ / "some.yaml", "header: {tick: 1}\n---\nheader: {tick: 2}\nkind: 1\n");
  const std::string file = "@" + (directory_ / "some.yaml").string();
  EXPECT_EQ(topic({"pub", "a", file}).exit_code, 0);
  EXPECT_EQ(take_some(reader, 2).size(), 2U);
  const auto begin = std::chrono::steady_clock::now();
  const Finished paced = topic({"pub", "a", file, "--rate", "20", "-n", "5"});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(paced.exit_code, 0) << paced.err;
  EXPECT_GE(took.count(), 0.2) << "4 periods of 50 ms";
  const auto taken = take_some(reader, 5);
  ASSERT_EQ(taken.size(), 5U);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    EXPECT_EQ(bus::decode<scarab_JointCommand>(taken[i].cdr)->header.tick, i % 2 + 1);
  }
  write_text(directory_ / "bad.yaml", "header: {tick: 1}\n---\nkinnd: 1\n");
  expect_refused(2, {"pub", "a", "@" + (directory_ / "bad.yaml").string()},
                 "bad.yaml, value 2: no member kinnd");
  expect_refused(2, {"pub", "a", "@" + (directory_ / "none.yaml").string()}, "cannot read");
  expect_refused(2, {"pub", "a", "@" + directory_.path().string()}, "Is a directory");
}

TEST_F(Pub, SendsWhatComesOnStandardInput) {
  const AnyReader reader(plant_, "a", bus::descriptor<scarab_JointCommand>());
  write_text(directory_ / "in",
             "# as echo prints them\nheader:\n  tick: 1\n---\n{\"header\": {\"tick\": 2}}\n"
             "{\"header\":\n  {\"tick\": 3}}\n\nheader:\n  tick: 4\n");
  ChildProcess pub = start_topic({"pub", "a", "-"}, directory_ / "in");
  EXPECT_EQ(pub.wait(kPatience), 0) << pub.err();
  EXPECT_THAT(pub.out(), StartsWith("published 4 samples"));
  const auto taken = take_some(reader, 4);
  ASSERT_EQ(taken.size(), 4U);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    EXPECT_EQ(bus::decode<scarab_JointCommand>(taken[i].cdr)->header.tick, i + 1);
  }
  write_text(directory_ / "bad", "{\"header\": {}}\n{\"heder\": {}}\n");
  ChildProcess bad = start_topic({"pub", "a", "-"}, directory_ / "bad");
  EXPECT_EQ(bad.wait(kPatience), 2);
  EXPECT_THAT(bad.err(), HasSubstr("standard input, value 2: no member heder"));
}

TEST_F(Pub, IsInterrupted) {
  const AnyReader reader(plant_, "a", bus::descriptor<scarab_JointCommand>());
  ChildProcess endless = start_topic({"pub", "a", "{}", "--rate", "50"});
  ASSERT_GE(take_some(reader, 3).size(), 3U);
  endless.signal(SIGINT);
  EXPECT_EQ(endless.wait(kPatience), 0) << "without end is its purpose";
  ChildProcess counted = start_topic({"pub", "a", "{}", "--rate", "50", "-n", "100000"});
  ASSERT_GE(take_some(reader, 3).size(), 3U);
  counted.signal(SIGINT);
  EXPECT_EQ(counted.wait(kPatience), 130);
}

}  // namespace
}  // namespace scarab::test
