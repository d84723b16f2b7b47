/// What replay makes of a log before anything is published.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "common/bus/topic_type.hpp"
#include "services/logger/core/base64.hpp"
#include "tests/unit/log/behaviour_log.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"
#include "tools/log/replay/answer_book.hpp"
#include "tools/log/replay/base64.hpp"
#include "tools/log/replay/excerpt.hpp"
#include "tools/log/replay/header_edit.hpp"
#include "tools/log/replay/pace.hpp"
#include "tools/log/replay/service_under_test.hpp"
#include "tools/log/replay/topic_writer.hpp"

namespace scarab::log::test {
namespace {

using mcap::test::TemporaryFolder;
using testing::ElementsAre;

/// The publish times, in s, in the order in which they come again.
std::vector<double> in_order(const std::vector<std::pair<double, double>>& log_and_publish_s) {
  std::vector<double> order;
  TimeOrder time_order([&](TimedMessage& message) {
    order.push_back(static_cast<double>(message.publish_time_ns) / kSecond);
    return true;
  });
  const LogChannel channel;
  const auto ns = [](double s) { return static_cast<std::uint64_t>(s * kSecond); };
  for (const auto& [log_s, publish_s] : log_and_publish_s) {
    EXPECT_TRUE(time_order.push(channel, {1, 0, ns(log_s), ns(publish_s), {}}));
  }
  EXPECT_TRUE(time_order.flush());
  return order;
}

TEST(TimeOrder, IsThatOfPublication) {
  EXPECT_THAT(in_order({{10.5, 10.2}, {10.5, 10.4}, {10.5, 10.1}, {10.5, 10.3}, {12, 12}}),
              ElementsAre(10.1, 10.2, 10.3, 10.4, 12));
}

TEST(TimeOrder, AnOldSampleComesWhenItWasRecorded) {
  EXPECT_THAT(in_order({{10, 9.9}, {11, 3}, {12, 11.9}}), ElementsAre(9.9, 3, 11.9));
}

TEST(TimeOrder, AClockThatIsAheadDoesNotCount) {
  EXPECT_THAT(in_order({{10, 70}, {11, 10.5}, {12, 11.5}}), ElementsAre(70, 10.5, 11.5));
}

TEST(TimeOrder, HoldsNoMoreThanItsWindow) {
  std::size_t emitted = 0;
  TimeOrder order([&](TimedMessage&) { return ++emitted < 60; });
  const LogChannel channel;
  std::size_t pushed = 0;
  while (order.push(channel, {1, 0, pushed * kSecond / 10, pushed * kSecond / 10, {}})) {
    ++pushed;
    ASSERT_LE(pushed - emitted, 11U);
  }
  EXPECT_EQ(emitted, 60U) << "it goes on after it was told to end";
}

TEST(HeaderEdit, ChangesOneFieldInEitherByteOrder) {
  const sample::Bytes encoded = bus::encode(behaviour(7, 3, 11));
  const auto* data = reinterpret_cast<const std::uint8_t*>(encoded.data());
  mcap::Bytes cdr(data, data + encoded.size());
  set_trial(cdr, 0x01020304);
  set_stamp(cdr, -5);
  const auto header = logger::read_sample_header(cdr.data(), cdr.size());
  EXPECT_EQ(header->trial, 0x01020304U);
  EXPECT_EQ(header->tick, 3U);
  EXPECT_EQ(header->sim_time_ns, 300'000'000);
  EXPECT_EQ(header->stamp_ns, -5);

  mcap::Bytes big(32, 0);
  set_trial(big, 0x01020304);
  set_stamp(big, 0x05);
  EXPECT_EQ(big[4], 1);
  EXPECT_EQ(logger::read_sample_header(big.data(), big.size())->trial, 0x01020304U);
  EXPECT_EQ(logger::read_sample_header(big.data(), big.size())->stamp_ns, 5);
}

TEST(Base64, IsTheReverseOfTheRecorders) {
  std::vector<std::uint8_t> bytes;
  for (int size = 0; size < 70; ++size) {
    const sample::Bytes back = base64_bytes(logger::base64(bytes.data(), bytes.size()));
    ASSERT_EQ(back.size(), bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      ASSERT_EQ(std::to_integer<unsigned>(back[i]), bytes[i]);
    }
    bytes.push_back(static_cast<std::uint8_t>(size * 37 + 200));
  }
  EXPECT_THROW(base64_bytes("ab*d"), bus::Error);
}

TEST(Pace, IsThatOfTheLogTimesTheSpeed) {
  const Pace::Clock::time_point now = Pace::Clock::now();
  Pace twice(2.0);
  twice.start(10 * kSecond, now);
  EXPECT_EQ(twice.due(10 * kSecond), now);
  EXPECT_EQ(twice.due(9 * kSecond), now);
  EXPECT_EQ(twice.due(14 * kSecond), now + std::chrono::seconds(2));
  Pace max(std::nullopt);
  max.start(10 * kSecond, now);
  EXPECT_EQ(max.due(1000 * kSecond), now);
}

TEST(ServiceUnderTest, IsNamedByTheLogOrElseByTheStack) {
  LogChannel channel;
  channel.topic = "scarab/robot_state";
  EXPECT_EQ(writer_of(channel), (bus::Peer{"plant", 0}));
  channel.record.metadata["writers"] = "robot_bridge/2 robot_bridge/3";
  EXPECT_EQ(writer_of(channel), (bus::Peer{"robot_bridge", 2}));
  channel.record.metadata["writers"] = "";
  channel.topic = "scarab/trial";
  EXPECT_EQ(writer_of(channel), (bus::Peer{"experiment", 0}));
  EXPECT_THROW(service_under_test("plant", 0), std::invalid_argument);
}

TEST(RecordedQos, IsReadFromTheChannel) {
  LogChannel channel;
  channel.topic = "meadow";
  EXPECT_EQ(recorded_qos(channel).durability, DDS_DURABILITY_VOLATILE);
  channel.record.metadata["qos.durability"] = "transient-local";
  channel.record.metadata["qos.partition.0"] = "left";
  EXPECT_EQ(recorded_qos(channel).partitions, std::vector<std::string>{"left"});
  channel = {};
  channel.topic = "scarab/behaviour";  // of a log from before QoS was recorded
  EXPECT_EQ(recorded_qos(channel).durability, DDS_DURABILITY_TRANSIENT_LOCAL);
}

class Excerpts : public testing::Test {
 protected:
  Excerpts() {
    LogWriter log(folder_ / "x.mcap");
    for (std::uint32_t i = 0; i < 10; ++i) log.write(behaviour(1 + i / 5, i, 0));
    const auto meadow = log.add_channel("meadow", "meadow::Patch", "omgidl", kMeadowIdl);
    log.write(meadow, 10 * kSecond, patch(1, {}));
    log.close();
  }
  std::vector<std::uint32_t> ticks(const ReplayOptions& options) {
    std::vector<std::uint32_t> ticks;
    const Log log(folder_ / "x.mcap");
    Excerpt(log, options).for_each([&](TimedMessage& message) {
      const auto header = logger::read_sample_header(message.cdr.data(), message.cdr.size());
      ticks.push_back(message.channel->has_header ? header->tick : 99);
      return true;
    });
    return ticks;
  }
  TemporaryFolder folder_;
};

TEST_F(Excerpts, HaveTopicsATrialAndATime) {
  ReplayOptions options;
  EXPECT_EQ(ticks(options).size(), 11U);
  options.except = {"meadow"};
  options.trial = 2;
  EXPECT_THAT(ticks(options), ElementsAre(5, 6, 7, 8, 9));
  options = {};
  options.from_s = 2.5;
  options.to_s = 5.5;
  options.topics = {"scarab/behaviour"};
  // Message n was recorded n + 1 s after the epoch, published a second before.
  EXPECT_THAT(ticks(options), ElementsAre(4, 5, 6));
  options = {};
  options.trial = 1;
  EXPECT_THAT(ticks(options), ElementsAre(0, 1, 2, 3, 4, 99)) << "what is of no trial comes along";
  options.topics = {"nothing"};
  EXPECT_THROW(ticks(options), std::invalid_argument);
}

class Answers : public testing::Test {
 protected:
  static logger::SampleHeader header(std::uint32_t tick) { return {1, tick, tick * 100LL, 0}; }
  static mcap::Bytes cdr(std::uint32_t tick, double as_rad = 0) {
    scarab_Behaviour sample = behaviour(1, tick, tick * 7);
    sample.as_rad = as_rad;
    const sample::Bytes bytes = bus::encode(sample);
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    return {data, data + bytes.size()};
  }
  static LogChannel channel() {
    LogChannel channel;
    channel.topic = "scarab/behaviour";
    channel.type = bus::model_of(bus::descriptor<scarab_Behaviour>());
    channel.has_header = true;
    return channel;
  }
  const LogChannel channel_ = channel();
  AnswerBook book_{&channel_, channel_, {}};
};

TEST_F(Answers, AreHeldAgainstTheRecordedOnesWhicheverComesFirst) {
  book_.add_recorded(header(0), cdr(0));
  EXPECT_TRUE(book_.awaits_answers());
  book_.add_answered(header(0), cdr(0));
  book_.add_answered(header(1), cdr(1));
  EXPECT_EQ(book_.answered_tick(), 1);
  EXPECT_FALSE(book_.awaits_answers());
  book_.add_recorded(header(1), cdr(1));
  EXPECT_EQ(book_.equal(), 2U);
  EXPECT_EQ(book_.recorded(), 2U);
}

TEST_F(Answers, TheFirstOtherOneIsNamed) {
  for (std::uint32_t tick = 0; tick < 5; ++tick) {
    book_.add_recorded(header(tick), cdr(tick));
    book_.add_answered(header(tick), cdr(tick, tick < 3 ? 0 : 0.5));
  }
  EXPECT_EQ(book_.equal(), 3U);
  EXPECT_EQ(book_.different(), 2U);
  ASSERT_TRUE(book_.first());
  EXPECT_EQ(book_.first()->header.tick, 3U);
  EXPECT_EQ(to_string(book_.first()->field), "as_rad: 0 and 0.5");
}

TEST_F(Answers, WhatIsSaidAgainCountsOnce) {
  for (int time = 0; time < 2; ++time) {
    book_.add_recorded(header(0), cdr(0));
    book_.add_answered(header(0), cdr(0));
  }
  book_.close_trial();
  EXPECT_EQ(book_.equal(), 1U);
  EXPECT_EQ(book_.unanswered() + book_.unrecorded(), 0U);
}

TEST_F(Answers, WhatHasNoCounterpartIsCountedWhenTheTrialEnds) {
  book_.add_recorded(header(0), cdr(0));
  book_.add_recorded(header(1), cdr(1));
  book_.add_answered(header(1), cdr(1));
  book_.add_answered(header(2), cdr(2));
  book_.close_trial();
  EXPECT_EQ(book_.unanswered(), 1U);
  EXPECT_EQ(book_.unrecorded(), 1U);
  EXPECT_EQ(book_.answered_tick(), -1) << "the next trial begins at its tick 0";
  book_.add_recorded(header(0), cdr(0));
  book_.add_answered(header(0), cdr(0));
  EXPECT_EQ(book_.equal(), 2U);
}

}  // namespace
}  // namespace scarab::log::test
