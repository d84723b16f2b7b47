#include <cmath>
#include <vector>

#include "tests/integration/plant/fixture.hpp"

namespace scarab::test {
namespace {

constexpr std::int64_t kTickNs = 100'000'000;

class RealTime : public PlantProcess {
 protected:
  RealTime() : PlantProcess({"--pace", "realtime"}) {}
};

TEST_F(RealTime, TicksFollowTheWallClock) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 19)) << child_.err();
  const auto& states = ends_.states().all();
  // Late by what a loaded machine takes, but not drifting; and never early.
  constexpr std::int64_t kEarlyNs = 2'000'000;
  constexpr std::int64_t kLateNs = 1'000'000'000;
  for (std::uint32_t tick = 1; tick <= 20; ++tick) {
    const std::int64_t since = states[tick].header.stamp_ns - states[0].header.stamp_ns;
    EXPECT_GE(since, tick * kTickNs - kEarlyNs) << "tick " << tick;
    EXPECT_LE(since, tick * kTickNs + kLateNs) << "tick " << tick;
  }
}

TEST_F(RealTime, CommandsThatStopComingBringTheSafeStop) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(ends_.run(1, 0, 4));
  const std::uint32_t answered = ends_.states().all().back().header.tick;
  std::optional<std::uint32_t> stopped;
  ASSERT_TRUE(eventually([&] {
    const auto& last = ends_.states().all().back();
    if (last.phase == scarab_PHASE_SAFE_STOP) stopped = last.header.tick;
    return stopped.has_value();
  })) << child_.err();
  EXPECT_GE(*stopped, answered + 2);  // one late command is no reason
  EXPECT_TRUE(counted("safe_stops", 1));
  EXPECT_TRUE(status_.await_message(self_, "safe stop: no valid joint_command"));
  // Commands that come again do not end it: that takes a reset.
  const std::uint32_t next = *stopped + 1;
  ASSERT_TRUE(ends_.run(1, next, next + 3));
  EXPECT_EQ(ends_.states().all().back().phase, scarab_PHASE_SAFE_STOP);
}

}  // namespace
}  // namespace scarab::test
