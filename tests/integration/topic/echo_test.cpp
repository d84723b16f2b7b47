#include <csignal>
#include <thread>

#include "common/bus/sample_fields.hpp"
#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

struct Echo : TopicTool {
  bus::RawQos all_kept() const {
    bus::RawQos qos = kept();
    qos.history_depth = 0;
    return qos;
  }
  /// Ticks 0 to 9, kept for late readers.
  AnyWriter writer{plant_, "a", bus::descriptor<scarab_JointCommand>(), all_kept()};

  void SetUp() override {
    for (std::uint32_t tick = 0; tick < 10; ++tick) {
      scarab_JointCommand sample = joint_command(tick);
      sample.kind = tick % 2 == 0 ? scarab_COMMAND_STOP : scarab_COMMAND_POSITION;
      sample.position_rad[3] = 0.5 * tick;
      writer.write(&sample);
    }
  }
};

TEST_F(Echo, PrintsYamlAndJson) {
  const Finished yaml = topic({"echo", "a", "-n", "2"});
  EXPECT_EQ(yaml.exit_code, 0) << yaml.err;
  EXPECT_THAT(yaml.out,
              AllOf(StartsWith("header:\n  trial: 0\n  tick: 0\n"),
                    HasSubstr("---\nheader:\n  trial: 0\n  tick: 1\n"), EndsWith("0, 0]\n---\n")));
  const Finished json = topic({"echo", "a", "--once", "--json"});
  EXPECT_EQ(json.exit_code, 0) << json.err;
  EXPECT_EQ(json.out,
            "{\"header\": {\"trial\": 0, \"tick\": 0, \"sim_time_ns\": 0, \"stamp_ns\": 0}, "
            "\"kind\": \"COMMAND_STOP\", \"position_rad\": [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, "
            "0, 0, 0, 0, 0, 0]}\n");
}

TEST_F(Echo, PrintsSingleFields) {
  EXPECT_EQ(topic({"echo", "a", "-n", "3", "--field", "header.tick"}).out, "0\n1\n2\n");
  EXPECT_EQ(topic({"echo", "a", "-n", "2", "--field", "kind"}).out,
            "COMMAND_STOP\nCOMMAND_POSITION\n");
  EXPECT_EQ(topic({"echo", "a", "-n", "1", "--field", "kind", "--json"}).out, "\"COMMAND_STOP\"\n");
  EXPECT_EQ(topic({"echo", "a", "-n", "1", "--field", "header"}).out,
            "{\"trial\": 0, \"tick\": 0, \"sim_time_ns\": 0, \"stamp_ns\": 0}\n");
  EXPECT_EQ(topic({"echo", "a", "-n", "2", "--field", "header.tick", "--field", "kind"}).out,
            "header.tick: 0\nkind: COMMAND_STOP\n---\n"
            "header.tick: 1\nkind: COMMAND_POSITION\n---\n");
  EXPECT_EQ(
      topic({"echo", "a", "--once", "--json", "--field", "header.tick", "--field", "kind"}).out,
      "{\"header.tick\": 0, \"kind\": \"COMMAND_STOP\"}\n");
}

TEST_F(Echo, PrintsTables) {
  const Finished table =
      topic({"echo", "a", "-n", "2", "--csv", "--field", "position_rad[3]", "--field", "header"});
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_EQ(table.out,
            "position_rad[3],header.trial,header.tick,header.sim_time_ns,header.stamp_ns\n"
            "0,0,0,0,0\n0.5,0,1,0,0\n");
}

TEST_F(Echo, PrintsElementsOfSequences) {
  std::vector<scarab_Contact> contacts(2);
  contacts[1].leg_b = 4;
  scarab_WorldState state{};
  bus::borrow(state.contacts, contacts);
  bus::Writer<scarab_WorldState> worlds(plant_, bus::kWorldState);
  worlds.write(state);
  EXPECT_EQ(topic({"echo", "scarab/world_state", "--once", "--csv", "--field", "contacts.length",
                   "--field", "contacts[1].leg_b", "--field", "contacts[2].leg_b"})
                .out,
            "contacts.length,contacts[1].leg_b,contacts[2].leg_b\n2,4,\n");
  EXPECT_EQ(topic({"echo", "scarab/world_state", "--once", "--field", "contacts.length"}).out,
            "2\n");
  EXPECT_EQ(topic({"echo", "scarab/world_state", "--once", "--field", "contacts[2].leg_b"}).out,
            "null\n");
}

TEST_F(Echo, PrintsOnlyWhatTheFilterWants) {
  const Finished some = topic({"echo", "a", "-n", "2", "--field", "header.tick", "--filter",
                               "header.tick > 4 AND kind = 'COMMAND_POSITION'"});
  EXPECT_EQ(some.exit_code, 0) << some.err;
  EXPECT_EQ(some.out, "5\n7\n");
  expect_refused(3, {"echo", "a", "--filter", "header.tick > 100", "--timeout", "0.5"},
                 "a: no sample that matches the filter within 0.5 s");
}

TEST_F(Echo, RefusesWhatItCannotDo) {
  expect_refused(2, {"echo", "a", "--field", "header.tik"},
                 "--field: no member tik in scarab::Header; it has trial, tick, sim_time_ns, "
                 "stamp_ns; did you mean tick?");
  expect_refused(2, {"echo", "a", "--field", "position_rad[19]"}, "position_rad has 19 elements");
  expect_refused(2, {"echo", "a", "--filter", "header.tick == 3"},
                 "--filter: column 13: equal is written =");
  expect_refused(2, {"echo", "a", "--filter", "kinnd = 3"}, "did you mean kind?");
  expect_refused(2, {"echo", "a", "--csv", "--json"}, "excludes");
  expect_refused(2, {"echo", "a", "-n", "0"}, "--count");
  expect_refused(2, {"echo"}, "topic is required");
  expect_refused(2, {"shout", "a"}, "unknown command 'shout'");
}

TEST_F(Echo, WantsATopicThatIsWritten) {
  const AnyReader reader(plant_, "b", bus::descriptor<scarab_JointCommand>());
  expect_refused(4, {"echo", "b", "--timeout", "0.3"}, "b has no writer; it is read by plant/0");
  expect_refused(4, {"echo", "scarab/none", "--timeout", "0.3"}, "there are a, b");
}

TEST_F(Echo, SaysThatNothingCame) {
  const AnyWriter silent(plant_, "b", bus::descriptor<scarab_JointCommand>());
  expect_refused(3, {"echo", "b", "--once", "--timeout", "0.3"}, "b: no sample within 0.3 s");
}

TEST_F(Echo, EndsAtCtrlC) {
  const auto end_of = [&](const Arguments& words) {
    ChildProcess echo = start_topic(words);
    EXPECT_TRUE(eventually([&] { return echo.out().find("tick: 9") != std::string::npos; }))
        << echo.err();
    echo.signal(SIGINT);
    return echo.wait(kPatience);
  };
  EXPECT_EQ(end_of({"echo", "a"}), 0) << "it looks without end";
  EXPECT_EQ(end_of({"echo", "a", "-n", "11"}), 130) << "one is missing";
}

TEST_F(Echo, EndsQuietlyWithItsReader) {
  // More than a pipe holds, so that it meets the closed end.
  const Finished piped = run({"/bin/sh", "-c",
                              "(" + program("scarab-topic") + " echo a --tag '" + test_tag() +
                                  "'; echo $? >&2) | head -n 1"});
  EXPECT_EQ(piped.out, "header:\n");
  EXPECT_EQ(piped.err, "0\n");
}

}  // namespace
}  // namespace scarab::test
