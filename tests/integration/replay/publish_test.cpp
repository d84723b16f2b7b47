/// Logs that are published again, seen by a participant that reads them.
#include <pond.h>

#include <csignal>
#include <regex>

#include "common/bus/clock.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "tests/integration/replay/fixture.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/inbox.hpp"
#include "tests/unit/log/behaviour_log.hpp"

namespace scarab::bus {

template <>
inline const dds_topic_descriptor_t& descriptor<pond_Newt>() {
  return pond_Newt_desc;
}

}  // namespace scarab::bus

namespace scarab::test {
namespace {

using testing::HasSubstr;

constexpr bus::Topic<pond_Newt> kNewts{"pond/newts", bus::Profile::kState};

class Publish : public ReplayTest {
 protected:
  /// Behaviours every 100 ms, the n-th with backbone_rad n.
  std::filesystem::path behaviours(std::uint32_t count) {
    log::test::LogWriter log(directory_ / "x.mcap");
    for (std::uint32_t i = 0; i < count; ++i) {
      auto sample = log::test::behaviour(1, i, 1000 + i);
      sample.backbone_rad = i;
      const sample::Bytes cdr = bus::encode(sample);
      log.write_at(bus::kBehaviour, kBegin + i * kPeriod, {cdr.data(), cdr.size()});
    }
    log.close();
    return directory_ / "x.mcap";
  }

  static constexpr std::uint64_t kBegin = 1'700'000'000'000'000'000U;
  static constexpr std::uint64_t kPeriod = 100'000'000;  // ns
};

/// A sample, and when it was published.
struct Seen {
  scarab_Behaviour sample;
  std::int64_t source_ns = 0;
};

TEST_F(Publish, EverySampleComesAsRecordedAndNotBeforeItsTime) {
  constexpr std::uint32_t kCount = 20;
  const auto log = behaviours(kCount);
  bus::Participant participant(test_options("observer"));
  bus::Reader<scarab_Behaviour> reader(participant, bus::kBehaviour);
  bus::WaitSet wait_set(participant);
  wait_set.attach(reader);
  std::vector<Seen> seen;
  auto child = start_replay(log, {"--speed", "2", "--wait", "1"});
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (seen.size() < kCount && std::chrono::steady_clock::now() < end) {
    wait_set.wait(std::chrono::milliseconds(100));
    reader.take_with_info([&](const scarab_Behaviour& sample, const bus::SampleInfo& info) {
      if (info.valid) seen.push_back({sample, info.source_ns});
    });
  }
  EXPECT_EQ(child.wait(kPatience), 0) << child.err();
  EXPECT_THAT(child.out(), HasSubstr("replayed: 20 samples of 1 topic\n"));
  ASSERT_EQ(seen.size(), kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    EXPECT_EQ(seen[i].sample.header.tick, i);
    EXPECT_EQ(seen[i].sample.header.stamp_ns, 1000 + i);
    EXPECT_EQ(seen[i].sample.backbone_rad, i);
    EXPECT_EQ(bus::text(seen[i].sample.reason), "walks, \"slowly\"");
    EXPECT_GT(seen[i].source_ns, static_cast<std::int64_t>(kBegin + kPeriod * kCount));
    // The first may have been late by as much as the machine is slow, by which the others seem
    // early.
    const std::int64_t due_ns = static_cast<std::int64_t>(kPeriod / 2) * i;
    EXPECT_GE(seen[i].source_ns - seen[0].source_ns, due_ns - 300'000'000) << i;
  }
  EXPECT_GT(seen.back().source_ns - seen.front().source_ns, 600'000'000);
  EXPECT_LT(seen.back().source_ns - seen.front().source_ns, 5'000'000'000);
}

TEST_F(Publish, TimesCanBeKeptOrMadeNew) {
  const auto log = behaviours(3);
  const auto observe = [&](const Arguments& more) {
    bus::Participant participant(test_options("observer"));
    bus::Reader<scarab_Behaviour> reader(participant, bus::kBehaviour);
    Arguments arguments = {"--speed", "max", "--wait", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    auto child = start_replay(log, arguments);
    std::vector<Seen> seen;
    EXPECT_TRUE(eventually([&] {
      reader.take_with_info([&](const scarab_Behaviour& sample, const bus::SampleInfo& info) {
        if (info.valid) seen.push_back({sample, info.source_ns});
      });
      return seen.size() == 3;
    }));
    EXPECT_EQ(child.wait(kPatience), 0) << child.err();
    return seen;
  };
  const auto kept = observe({"--keep-times"});
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept[2].source_ns, static_cast<std::int64_t>(kBegin + 2 * kPeriod));
  const auto before = bus::now_ns();
  const auto stamped = observe({"--restamp"});
  ASSERT_EQ(stamped.size(), 3U);
  EXPECT_GE(stamped[0].sample.header.stamp_ns, before);
}

TEST_F(Publish, FastNothingIsLost) {
  constexpr std::uint32_t kCount = 3000;
  const auto log = behaviours(kCount);
  bus::Participant participant(test_options("observer"));
  bus::ReaderOptions keep_all;
  keep_all.keep_all = true;
  bus::Reader<scarab_Behaviour> reader(participant, bus::kBehaviour, keep_all);
  auto child = start_replay(log, {"--speed", "max", "--wait", "1"});
  EXPECT_EQ(child.wait(std::chrono::seconds(60)), 0) << child.err();
  std::uint32_t next = 0;
  eventually([&] {
    reader.take([&](const scarab_Behaviour& sample) { EXPECT_EQ(sample.header.tick, next++); });
    return next >= kCount;
  });
  EXPECT_EQ(next, kCount);
}

TEST_F(Publish, WhereSomebodyWritesTheTopicItIsRefused) {
  const auto log = behaviours(3);
  bus::Participant participant(test_options("supervisor"));
  const bus::Writer<scarab_Behaviour> writer(participant, bus::kBehaviour);
  const Finished refused = replay(log, {"--speed", "max"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("scarab/behaviour is being written by supervisor/0"));
  EXPECT_EQ(replay(log, {"--speed", "max", "--force"}).exit_code, 0);
}

TEST_F(Publish, CtrlCEndsItSayingHowFarItCame) {
  const auto log = behaviours(3);
  bus::Participant participant(test_options("observer"));
  Inbox<scarab_Behaviour> inbox(participant, bus::kBehaviour);
  auto child = start_replay(log, {"--loop", "--speed", "10"});
  ASSERT_TRUE(eventually([&] { return inbox.all().size() > 7; })) << child.err();
  child.signal(SIGINT);
  EXPECT_EQ(child.wait(kPatience), 130);
  EXPECT_THAT(child.out(), HasSubstr("then interrupted"));
}

pond_Newt newt(std::int32_t number, std::vector<float>& meals) {
  pond_Newt sample{};
  sample.number = number;
  sample.colour = number % 2 == 0 ? pond_COLOUR_GREEN : pond_COLOUR_RED;
  sample.place_m[1] = 0.25 * number;
  bus::assign(sample.name, "newt " + std::to_string(number));
  meals.assign(static_cast<std::size_t>(number % 9), static_cast<float>(number));
  bus::borrow(sample.meals, meals);
  return sample;
}

/// Recorded by a recorder that is killed, mended, and published again, all by programs that know
/// nothing of the type.
TEST_F(Publish, AForeignTopicOutOfTheLogOfAKilledRecorder) {
  constexpr std::int32_t kCount = 30;
  const auto active = directory_ / "trial.mcap.active";
  {
    write_text(directory_ / "logger.yaml", "chunk_time_s: 0.02\n");
    ChildProcess logger({program("scarab-logger"), "--tag", test_tag(), "--output",
                         directory_ / "trial.mcap", "--config", directory_ / "logger.yaml"},
                        directory_ / "logger");
    bus::Participant participant(test_options("pond"));
    bus::Writer<pond_Newt> writer(participant, kNewts);
    ASSERT_TRUE(eventually([&] { return !writer.matched().empty(); })) << logger.err();
    std::vector<float> meals;
    for (std::int32_t i = 0; i < kCount; ++i) writer.write(newt(i, meals));
    ASSERT_TRUE(eventually([&] {
      const Finished info = run({program("scarab-log"), "info", active});
      return info.out.find("pond::Newt ") != std::string::npos &&
             std::regex_search(info.out, std::regex("pond::Newt +30 "));
    })) << logger.err();
    logger.kill();
  }
  const Finished mended = run({program("scarab-log"), "recover", active});
  ASSERT_EQ(mended.exit_code, 0) << mended.err;
  EXPECT_FALSE(std::filesystem::exists(active));
  bus::Participant participant(test_options("observer"));
  bus::ReaderOptions keep_all;
  keep_all.keep_all = true;
  bus::Reader<pond_Newt> reader(participant, kNewts, keep_all);
  const Finished done =
      replay(directory_ / "trial.mcap", {"--topic", "pond/newts", "--wait", "1", "--speed", "max"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  std::int32_t next = 0;
  eventually([&] {
    reader.take([&](const pond_Newt& sample) {
      std::vector<float> meals;
      const pond_Newt wanted = newt(next, meals);
      EXPECT_EQ(bus::encode(sample), bus::encode(wanted)) << next;
      ++next;
    });
    return next >= kCount;
  });
  EXPECT_EQ(next, kCount);
}

}  // namespace
}  // namespace scarab::test
