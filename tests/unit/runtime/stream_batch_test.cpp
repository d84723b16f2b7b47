#include "common/runtime/stream_batch.hpp"

#include <gtest/gtest.h>

namespace scarab::runtime {
namespace {

const StreamBatch::Clock::time_point kNow{std::chrono::hours(1)};

TEST(StreamBatch, LeavesEveryFewTicks) {
  StreamBatch batch(5);
  batch.sent(kNow);
  EXPECT_TRUE(batch.due(0, kNow));
  for (std::uint32_t tick = 1; tick < StreamBatch::kTicks; ++tick) {
    EXPECT_FALSE(batch.due(tick, kNow)) << tick;
  }
  EXPECT_TRUE(batch.due(StreamBatch::kTicks, kNow));
}

TEST(StreamBatch, LeavesEveryTickWhereTicksAreSlow) {
  StreamBatch batch(5);
  batch.sent(kNow);
  EXPECT_TRUE(batch.due(1, kNow + StreamBatch::kLongest));
}

TEST(StreamBatch, NothingThatIsLackingIsOverwritten) {
  for (const std::uint32_t samples : {1U, 5U, 8U, 20U, 50U, 100U}) {
    const StreamBatch batch(samples);
    ASSERT_GE(batch.lead(), 1U);
    const std::uint32_t outstanding = batch.lead() + batch.ticks() + 1;
    EXPECT_LE(outstanding * samples, bus::kStreamDepth) << samples << " samples a tick";
    EXPECT_LE(outstanding, bus::kDepth) << samples << " samples a tick";
  }
}

TEST(StreamBatch, OneTickAtATimeWhereWritersKeepFew) {
  EXPECT_EQ(StreamBatch(100).ticks(), 1U);
  EXPECT_EQ(StreamBatch(bus::kStreamDepth).lead(), 1U);
}

}  // namespace
}  // namespace scarab::runtime
