#include "common/runtime/logger_lead.hpp"

#include <gtest/gtest.h>

namespace scarab::runtime {
namespace {

TEST(LoggerLead, NothingThatIsLackingIsOverwritten) {
  for (unsigned samples = 1; samples <= kMostSamplesPerTick; ++samples) {
    const std::uint32_t lead = lead_over_logger(samples);
    ASSERT_GE(lead, 1U) << samples << " samples a tick";
    const std::uint32_t outstanding = lead + kTicksBesideTheLead;
    EXPECT_LE(outstanding * samples, bus::kStreamDepth) << samples << " samples a tick";
    EXPECT_LE(outstanding, bus::kDepth) << samples << " samples a tick";
  }
}

TEST(LoggerLead, IsAsLongAsAWriterKeepsTicks) {
  EXPECT_EQ(lead_over_logger(1), 62U);
  EXPECT_EQ(lead_over_logger(8), 62U);
  EXPECT_EQ(lead_over_logger(9), 54U);
  EXPECT_EQ(lead_over_logger(65), 5U);
}

TEST(LoggerLead, OneSampleMoreWouldLeaveNone) {
  EXPECT_EQ(lead_over_logger(kMostSamplesPerTick), 1U);
  EXPECT_GT((1 + kTicksBesideTheLead) * (kMostSamplesPerTick + 1), bus::kStreamDepth);
}

}  // namespace
}  // namespace scarab::runtime
