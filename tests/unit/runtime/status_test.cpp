#include <gmock/gmock.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <vector>

#include "common/runtime/status_board.hpp"
#include "common/runtime/status_publisher.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::runtime {
namespace {

using test::eventually;
using test::test_options;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

const bus::Peer kPremotor{"premotor", 0};

/// A service as far as its status goes.
struct Service {
  explicit Service(std::uint32_t instance = 0)
      : participant(test_options("premotor", instance)),
        status(participant, {"premotor", instance}) {
    status.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
    status.publish_if_due();
  }
  bus::Participant participant;
  StatusPublisher status;
};

class StatusTest : public testing::Test {
 protected:
  /// The report of premotor/0 once `condition(report)` holds.
  template <class Condition>
  bool reported(Condition&& condition) {
    return eventually([&] {
      board_.update();
      const auto* report = board_.find(kPremotor);
      return report && condition(*report);
    });
  }

  bus::Participant watcher_{test_options("experiment")};
  StatusBoard board_{watcher_};
};

TEST_F(StatusTest, HistogramsArriveAsTheyWere) {
  Histogram age, jitter;
  for (int us = 1; us < 30'000; us *= 2) age.add(std::chrono::microseconds(us));
  jitter.add(std::chrono::seconds(20));
  Service service;
  service.status.set_histogram("command_age", age);
  service.status.set_histogram("tick_jitter", jitter);
  service.status.set_ready(1);
  service.status.publish_if_due();
  ASSERT_TRUE(reported([](const auto& report) { return report.ready_trial == 1; }));
  const auto& shown = board_.find(kPremotor)->histograms;
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_EQ(shown.at("command_age").counts(), age.counts());
  EXPECT_EQ(shown.at("command_age").sum_s(), age.sum_s());
  EXPECT_EQ(shown.at("command_age").max_s(), age.max_s());
  EXPECT_EQ(shown.at("tick_jitter").counts(), jitter.counts());
}

TEST_F(StatusTest, BoardShowsWhatAServiceSays) {
  Service service;
  service.status.set_lifecycle(scarab_LIFECYCLE_ACTIVE);
  service.status.set_ready(3);
  service.status.set_health(scarab_HEALTH_DEGRADED, "one thing was refused");
  service.status.set_progress({3, 17, 1'700'000'000, 0});
  service.status.set_counter("commands_refused_stale", 2);
  service.status.publish_if_due();
  ASSERT_TRUE(reported([](const auto& report) { return report.ready_trial == 3; }));
  const auto& report = *board_.find(kPremotor);
  EXPECT_EQ(report.lifecycle, scarab_LIFECYCLE_ACTIVE);
  EXPECT_EQ(report.health, scarab_HEALTH_DEGRADED);
  EXPECT_EQ(report.message, "one thing was refused");
  EXPECT_EQ(report.header.tick, 17U);
  EXPECT_EQ(report.process_id, static_cast<std::uint32_t>(::getpid()));
  EXPECT_THAT(report.counters, ElementsAre(Pair("commands_refused_stale", 2U)));
}

TEST_F(StatusTest, LateBoardSeesTheLastWord) {
  Service service;
  service.status.set_ready(5);
  service.status.publish_if_due();
  ASSERT_TRUE(reported([](const auto& report) { return report.ready_trial == 5; }));
  bus::Participant late(test_options("late"));
  StatusBoard late_board(late);
  EXPECT_TRUE(eventually([&] {
    late_board.update();
    const auto* report = late_board.find(kPremotor);
    return report && report->ready_trial == 5;
  }));
}

TEST_F(StatusTest, ServiceThatEndsLeavesTheBoard) {
  auto service = std::make_unique<Service>();
  ASSERT_TRUE(reported([](const auto&) { return true; }));
  service.reset();
  EXPECT_TRUE(eventually([&] {
    board_.update();
    return board_.find(kPremotor) == nullptr;
  }));
}

TEST_F(StatusTest, RestartedServiceComesBack) {
  auto service = std::make_unique<Service>();
  ASSERT_TRUE(reported([](const auto&) { return true; }));
  service = std::make_unique<Service>();
  service->status.set_ready(2);
  service->status.publish_if_due();
  EXPECT_TRUE(reported([](const auto& report) { return report.ready_trial == 2; }));
}

TEST_F(StatusTest, MissingNamesWhoIsNotThereOrNotReady) {
  Service service;
  service.status.set_ready(4);
  service.status.publish_if_due();
  ASSERT_TRUE(reported([](const auto& report) { return report.ready_trial == 4; }));
  EXPECT_THAT(board_.missing({{"premotor", 1}}, 4), IsEmpty());
  EXPECT_THAT(board_.missing({{"premotor", 1}}, 0), IsEmpty());
  EXPECT_THAT(board_.missing({{"premotor", 1}}, 5), ElementsAre("premotor/0"));
  EXPECT_THAT(board_.missing({{"premotor", 2}, {"logger", 1}}, 4),
              ElementsAre("logger/0", "premotor/1"));
}

/// Cyclone tells a reader that a writer is alive again by its next sample only.
TEST_F(StatusTest, IsSaidAgainThoughNothingHasChanged) {
  bus::Reader<scarab_ServiceStatus> reader(watcher_, bus::kServiceStatus);
  Service service;
  std::vector<std::int64_t> stamps;
  EXPECT_TRUE(eventually([&] {
    service.status.publish_if_due();
    reader.take([&](const auto& status) { stamps.push_back(status.header.stamp_ns); });
    return stamps.size() == 3;
  }));
  ASSERT_EQ(stamps.size(), 3U);
  const auto apart = std::chrono::nanoseconds(stamps[2] - stamps[1]);
  EXPECT_GE(apart, StatusPublisher::kRepeatPeriod - std::chrono::milliseconds(1));
}

TEST_F(StatusTest, ChangesOfHealthGoOutAtOnceButProgressIsThinnedOut) {
  bus::Reader<scarab_ServiceStatus> reader(watcher_, bus::kServiceStatus);
  Service service;
  std::uint32_t newest = 0;
  std::size_t samples = 0;
  const auto take = [&] {
    samples += reader.take(
        [&](const scarab_ServiceStatus& status) { newest = std::max(newest, status.header.tick); });
  };
  ASSERT_TRUE(eventually([&] { return take(), samples == 1; }));
  const auto start = std::chrono::steady_clock::now();
  std::uint32_t tick = 0;
  // Progress alone, as fast as it can be told, for three periods.
  while (std::chrono::steady_clock::now() - start < 3 * StatusPublisher::kProgressPeriod) {
    service.status.set_progress({1, ++tick, 0, 0});
    service.status.publish_if_due();
    take();
  }
  ASSERT_GT(tick, 100U);
  service.status.set_health(scarab_HEALTH_FAULT, "broken");
  service.status.publish_if_due();
  ASSERT_TRUE(eventually([&] { return take(), newest == tick; }));
  EXPECT_LE(samples, 1U + 3U + 1U + 1U);
}

TEST_F(StatusTest, LongMessageIsCut) {
  Service service;
  service.status.set_health(scarab_HEALTH_FAULT, std::string(1000, 'x'));
  service.status.publish_if_due();
  EXPECT_TRUE(reported([](const auto& report) { return report.message == std::string(255, 'x'); }));
}

}  // namespace
}  // namespace scarab::runtime
