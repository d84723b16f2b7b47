#include <gmock/gmock.h>

#include <cstring>
#include <thread>

#include "common/bus/reader.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/bus/fixture.hpp"

namespace scarab::bus {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;

scarab_RobotState robot_state(std::uint32_t tick) {
  scarab_RobotState state{};
  state.header.tick = tick;
  return state;
}

TEST(Delivery, EverySampleArrivesInOrder) {
  Participant plant(test_options("plant"));
  Participant supervisor(test_options("supervisor"));
  Writer<scarab_JointCommand> writer(plant, kJointCommand);
  Reader<scarab_JointCommand> reader(supervisor, kJointCommand);
  ASSERT_TRUE(eventually([&] { return !writer.matched().empty() && !reader.matched().empty(); }));

  constexpr std::uint32_t kCount = 1000;
  WaitSet waitset(supervisor);
  waitset.attach(reader);
  std::vector<std::uint32_t> ticks;
  for (std::uint32_t tick = 0; tick < kCount; ++tick) {
    scarab_JointCommand command{};
    command.header.tick = tick;
    writer.write(command);
    ASSERT_TRUE(waitset.wait(seconds(10)));
    reader.take([&](const scarab_JointCommand& c) { ticks.push_back(c.header.tick); });
  }
  ASSERT_EQ(ticks.size(), kCount);
  for (std::uint32_t tick = 0; tick < kCount; ++tick) EXPECT_EQ(ticks[tick], tick);
  EXPECT_TRUE(reader.faults().empty());
  EXPECT_TRUE(writer.faults().empty());
}

TEST(Delivery, FirstSampleAfterTheMatchArrives) {
  for (int round = 0; round < 30; ++round) {
    Participant premotor(test_options("premotor"));
    Participant plant(test_options("plant"));
    Writer<scarab_JointCommand> writer(premotor, kJointCommand);
    Reader<scarab_JointCommand> reader(plant, kJointCommand);
    while (writer.matched().empty()) std::this_thread::yield();  // no later than it can be
    writer.write({});
    std::size_t taken = 0;
    EXPECT_TRUE(eventually([&] {
      taken += reader.take([](const scarab_JointCommand&) {});
      return taken == 1;
    })) << "round "
        << round;
  }
}

/// A plant's writers and somebody who reads them.
struct StagedSamples {
  explicit StagedSamples(bool gathers)
      : plant([&] {
          ParticipantOptions options = test_options("plant");
          options.gathers_samples = gathers;
          return options;
        }()) {}

  /// A volatile reader may miss the first.
  static ReaderOptions from_the_first() {
    ReaderOptions options;
    options.keep_all = true;
    return options;
  }
  bool matched() {
    return eventually([&] {
      return !sensors.matched().empty() && !states.matched().empty() &&
             reader.matched().size() == 1;
    });
  }
  /// Stages samples of the given ticks, then sends a mark on another topic; the ticks that have
  /// come when the mark has.
  std::vector<std::uint32_t> stage_and_mark(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) sensors.stage(robot_state(first + i));
    states.write(robot_state(first));
    EXPECT_TRUE(eventually([&] { return marks.take([](const scarab_RobotState&) {}) > 0; }));
    return take();
  }
  std::vector<std::uint32_t> take() {
    std::vector<std::uint32_t> ticks;
    reader.take([&](const scarab_RobotState& state) { ticks.push_back(state.header.tick); });
    return ticks;
  }

  Participant plant;
  Participant logger{test_options("logger")};
  Writer<scarab_RobotState> sensors{plant, kRobotSensors};
  Writer<scarab_RobotState> states{plant, kRobotState};
  Reader<scarab_RobotState> reader{logger, kRobotSensors, from_the_first()};
  Reader<scarab_RobotState> marks{logger, kRobotState};
};

TEST(Delivery, WhereSamplesAreGatheredStagedOnesWaitForTheFlush) {
  StagedSamples samples(true);
  ASSERT_TRUE(samples.matched());
  // A heartbeat, every 100 ms, would fetch what is staged: one round without one is enough.
  constexpr std::uint32_t kRounds = 20;
  std::uint32_t first = 0;
  bool waited = false;
  for (; first < kRounds * 5 && !waited; first += 5) {
    std::vector<std::uint32_t> ticks = samples.stage_and_mark(first, 5);
    waited = ticks.empty();
    samples.sensors.flush();
    ASSERT_TRUE(eventually([&] {
      for (const std::uint32_t tick : samples.take()) ticks.push_back(tick);
      return ticks.size() == 5;
    }));
    EXPECT_THAT(ticks, ElementsAre(first, first + 1, first + 2, first + 3, first + 4));
  }
  EXPECT_TRUE(waited);
}

TEST(Delivery, ElsewhereStagedSamplesLeaveAtOnce) {
  StagedSamples samples(false);
  ASSERT_TRUE(samples.matched());
  EXPECT_THAT(samples.stage_and_mark(1, 2), ElementsAre(1, 2));
}

TEST(Delivery, MatchedNamesThePeers) {
  Participant plant(test_options("plant"));
  Participant first(test_options("premotor", 0));
  Participant second(test_options("premotor", 1));
  Writer<scarab_JointCommand> writer_a(first, kJointCommand);
  Writer<scarab_JointCommand> writer_b(second, kJointCommand);
  Reader<scarab_JointCommand> reader(plant, kJointCommand);
  ASSERT_TRUE(eventually([&] { return reader.matched().size() == 2; }));
  EXPECT_THAT(reader.matched(), ElementsAre(Peer{"premotor", 0}, Peer{"premotor", 1}));
  ASSERT_TRUE(eventually([&] { return !writer_a.matched().empty(); }));
  EXPECT_THAT(writer_a.matched(), ElementsAre(Peer{"plant", 0}));
}

TEST(Delivery, ALateReaderGetsTheNewestStateOnly) {
  Participant plant(test_options("plant"));
  Writer<scarab_RobotState> writer(plant, kRobotState);
  for (std::uint32_t tick = 1; tick <= 5; ++tick) writer.write(robot_state(tick));

  Participant late(test_options("premotor"));
  Reader<scarab_RobotState> reader(late, kRobotState);
  WaitSet waitset(late);
  waitset.attach(reader);
  ASSERT_TRUE(waitset.wait(seconds(10)));
  std::vector<std::uint32_t> ticks;
  reader.take([&](const scarab_RobotState& s) { ticks.push_back(s.header.tick); });
  EXPECT_THAT(ticks, ElementsAre(5U));
}

TEST(Delivery, TagsKeepStacksApart) {
  ParticipantOptions other = test_options("plant");
  other.tag += "other";
  Participant plant(other);
  Participant friend_of_supervisor(test_options("plant"));
  Participant supervisor(test_options("supervisor"));
  Writer<scarab_RobotState> foreign(plant, kRobotState);
  Writer<scarab_RobotState> ours(friend_of_supervisor, kRobotState);
  Reader<scarab_RobotState> reader(supervisor, kRobotState);
  ASSERT_TRUE(eventually([&] { return !reader.matched().empty(); }));
  EXPECT_EQ(reader.matched().size(), 1U);
  EXPECT_TRUE(foreign.matched().empty());
}

TEST(Delivery, StatusTellsOfAWriterThatLeft) {
  Participant launcher(test_options("status"));
  Reader<scarab_ServiceStatus> reader(launcher, kServiceStatus);
  WaitSet waitset(launcher);
  waitset.attach(reader);
  std::string service = "premotor";
  std::vector<scarab_Counter> counters(2);
  assign(counters[1].name, "refused");
  counters[1].value = 7;
  {
    Participant premotor(test_options("premotor", 3));
    Writer<scarab_ServiceStatus> writer(premotor, kServiceStatus);
    scarab_ServiceStatus status{};
    borrow(status.service, service);
    status.instance = 3;
    borrow(status.counters, counters);
    writer.write(status);
    ASSERT_TRUE(waitset.wait(seconds(10)));
    const std::size_t taken = reader.take([&](const scarab_ServiceStatus& s) {
      EXPECT_STREQ(s.service, "premotor");
      EXPECT_EQ(s.instance, 3U);
      ASSERT_EQ(elements(s.counters).size(), 2U);
      EXPECT_EQ(text(elements(s.counters)[1].name), "refused");
      EXPECT_EQ(elements(s.counters)[1].value, 7U);
    });
    EXPECT_EQ(taken, 1U);
  }
  ASSERT_TRUE(waitset.wait(seconds(10)));
  std::vector<std::string> gone;
  reader.take_with_info([&](const scarab_ServiceStatus& s, const SampleInfo& info) {
    EXPECT_FALSE(info.valid);
    EXPECT_EQ(info.state, InstanceState::kNoWriters);
    gone.push_back(s.service + std::to_string(s.instance));
  });
  EXPECT_THAT(gone, ElementsAre("premotor3"));
}

TEST(Delivery, ASampleThatIsNoneOfItsTypeIsNotSent) {
  Participant supervisor(test_options("supervisor"));
  Writer<scarab_Behaviour> writer(supervisor, kBehaviour);
  scarab_Behaviour sample{};
  std::memset(sample.reason, 'x', sizeof(sample.reason));
  EXPECT_THAT([&] { writer.write(sample); },
              testing::ThrowsMessage<Error>(
                  testing::StrEq("writer on scarab/behaviour: reason: text without end")));
}

TEST(WaitSet, AGuardWakesItFromAnotherThread) {
  Participant participant(test_options("plant"));
  Guard guard(participant);
  WaitSet waitset(participant);
  waitset.attach(guard);
  EXPECT_FALSE(waitset.wait(milliseconds(0)));
  std::thread waker([&] { guard.trigger(); });
  EXPECT_TRUE(waitset.wait(seconds(10)));
  waker.join();
  EXPECT_TRUE(waitset.wait(seconds(0)));
  guard.clear();
  EXPECT_FALSE(waitset.wait(milliseconds(0)));
}

}  // namespace
}  // namespace scarab::bus
