#include "tools/emulator/faults/fault_plan.hpp"

#include <gtest/gtest.h>

#include "tools/emulator/faults/effects.hpp"
#include "tools/emulator/faults/fault_text.hpp"

namespace scarab::emulator {
namespace {

Fault fault(std::string_view text) { return std::get<Fault>(parse_fault_order(text)); }

std::vector<std::string> texts(const std::vector<Fault>& faults) {
  std::vector<std::string> out;
  for (const Fault& each : faults) out.push_back(to_text(each));
  return out;
}

using Texts = std::vector<std::string>;

TEST(FaultPlan, OneWithoutATimeHoldsAtOnceAndUntilCleared) {
  FaultPlan plan;
  plan.add(fault("unplug"), 10);
  EXPECT_EQ(texts(plan.update(10, std::nullopt).began), Texts{"unplug"});
  EXPECT_FALSE(plan.update(1e5, std::nullopt).any());
  EXPECT_EQ(texts(plan.active()), Texts{"unplug"});
  plan.clear();
  EXPECT_EQ(texts(plan.update(1e5, 3.0).ended), Texts{"unplug"});
  EXPECT_TRUE(plan.active().empty());
}

TEST(FaultPlan, ADurationCountsByTheWallClockWhileTheWorldStandsStill) {
  FaultPlan plan;
  plan.add(fault("unplug for 2"), 10);
  EXPECT_TRUE(plan.update(10, std::nullopt).any());
  EXPECT_FALSE(plan.update(11.99, std::nullopt).any());
  EXPECT_EQ(texts(plan.update(12, std::nullopt).ended), Texts{"unplug for 2"});
  EXPECT_FALSE(plan.update(10, 0.0).any()) << "it comes once";
}

TEST(FaultPlan, OneWithATimeComesInEveryTrial) {
  FaultPlan plan;
  plan.add(fault("stuck TR0 at 3 for 2"), 0);
  for (int trial = 0; trial < 2; ++trial) {
    const double start_s = 100 * trial;
    EXPECT_FALSE(plan.update(start_s, std::nullopt).any());
    EXPECT_FALSE(plan.update(start_s + 2.9, 2.9).any());
    EXPECT_EQ(plan.update(start_s + 3, 3.0).began.size(), 1U);
    EXPECT_FALSE(plan.update(start_s + 4.9, 4.9).any());
    EXPECT_EQ(plan.update(start_s + 5, 5.0).ended.size(), 1U);
  }
  plan.add(fault("late 1 at 7"), 200);
  EXPECT_TRUE(plan.update(208, 8.0).any());
  EXPECT_EQ(plan.update(209, std::nullopt).ended.size(), 1U) << "a new world has begun";
}

TEST(FaultPlan, ClearTakesAwayWhatWasToCome) {
  FaultPlan plan;
  plan.add(fault("unplug at 5"), 0);
  plan.clear();
  EXPECT_FALSE(plan.update(1, 6.0).any());
}

TEST(Effects, AreThoseOfAllTogether) {
  const Effects effects =
      effects_of({fault("lose 0.1"), fault("stuck TR0"), fault("stuck TL0"), fault("silent imu"),
                  fault("hot BJ 90"), fault("late 0.2"), fault("late 0.3"), fault("pose TL1 0.5")});
  EXPECT_EQ(effects.lose, 0.1);
  EXPECT_EQ(effects.flip, 0);
  EXPECT_EQ(effects.stuck.count(), 2U);
  EXPECT_TRUE(effects.imu_silent);
  EXPECT_FALSE(effects.board_silent);
  EXPECT_EQ(effects.temperature_c[robot::kBackboneSlot], 90);
  EXPECT_FALSE(effects.temperature_c[0]);
  EXPECT_EQ(effects.late_s, 0.3) << "the later one of a kind";
  EXPECT_EQ(effects.pose_rad[1], 0.5);
}

}  // namespace
}  // namespace scarab::emulator
