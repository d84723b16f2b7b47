#include "common/runtime/tick_pacer.hpp"

#include <gtest/gtest.h>

namespace scarab::runtime {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPeriod{100};

class TickPacerTest : public testing::Test {
 protected:
  TickPacerTest() { pacer_.restart(at(0)); }
  static TickPacer::TimePoint at(int ms) { return TickPacer::TimePoint(milliseconds(ms)); }

  TickPacer pacer_{kPeriod};
};

TEST_F(TickPacerTest, TicksAreDueEveryPeriodHoweverLateTheirWorkIsDone) {
  for (int tick = 0; tick < 50; ++tick) {
    EXPECT_EQ(pacer_.due(), at(tick * 100));
    EXPECT_EQ(pacer_.end(), at(tick * 100 + 100));
    pacer_.tick_begins(at(tick * 100 + tick % 7));
    pacer_.tick_ends(at(tick * 100 + 100 + tick % 13));
  }
}

TEST_F(TickPacerTest, CountsEachTicksLateness) {
  for (const int late_ms : {0, 3, 40}) {
    pacer_.restart(at(1000));
    pacer_.tick_begins(at(1000 + late_ms));
  }
  EXPECT_EQ(pacer_.jitter().total(), 3U);
  EXPECT_NEAR(pacer_.jitter().max_s(), 0.040, 1e-9);
  EXPECT_NEAR(pacer_.jitter().sum_s(), 0.043, 1e-9);
}

TEST_F(TickPacerTest, CountsFromBeginningToBeginningButNotAcrossARestart) {
  for (const int begun_ms : {0, 105, 200}) pacer_.tick_begins(at(begun_ms));
  EXPECT_EQ(pacer_.cycle().total(), 2U);
  EXPECT_NEAR(pacer_.cycle().sum_s(), 0.2, 1e-9);
  EXPECT_NEAR(pacer_.cycle().max_s(), 0.105, 1e-9);
  pacer_.restart(at(5000));  // a pause
  pacer_.tick_begins(at(5000));
  EXPECT_EQ(pacer_.cycle().total(), 2U);
}

TEST_F(TickPacerTest, CountsOnlyTicksThatOverran) {
  pacer_.tick_ends(at(99));
  pacer_.tick_ends(at(200));
  EXPECT_EQ(pacer_.overrun().total(), 0U);
  pacer_.tick_ends(at(330));
  EXPECT_EQ(pacer_.overrun().total(), 1U);
  EXPECT_NEAR(pacer_.overrun().max_s(), 0.030, 1e-9);
}

TEST_F(TickPacerTest, DoesNotCatchUpWithABurst) {
  pacer_.tick_ends(at(5000));  // the process was stopped for a while
  EXPECT_EQ(pacer_.due(), at(5000));
  pacer_.tick_ends(at(5100));
  EXPECT_EQ(pacer_.due(), at(5100));
}

}  // namespace
}  // namespace scarab::runtime
