#include "services/experiment/core/sample_sequence.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace scarab::experiment {
namespace {

constexpr std::int64_t kPeriodNs = 20'000'000;

std::string missed(const std::vector<int>& periods) {
  SampleSequence sequence("world_state");
  for (const int period : periods) sequence.see(period * kPeriodNs);
  return sequence.missed();
}

TEST(SampleSequence, IsWholeFromZeroOn) {
  EXPECT_EQ(missed({}), "");
  EXPECT_EQ(missed({0}), "");
  EXPECT_EQ(missed({0, 1, 2, 3, 4}), "");
}

TEST(SampleSequence, MayComeTwice) {
  EXPECT_EQ(missed({0, 0, 1, 1, 0, 1, 2, 3}), "");  // as after a restart
}

TEST(SampleSequence, NoticesAMissedFirst) { EXPECT_NE(missed({1, 2, 3}), ""); }

TEST(SampleSequence, NoticesAGapAnywhere) {
  EXPECT_NE(missed({0, 2, 3, 4}), "");
  EXPECT_NE(missed({0, 1, 3}), "");
  EXPECT_NE(missed({0, 1, 2, 3, 4, 8}), "");
}

TEST(SampleSequence, NamesTheFirstThatIsMissing) {
  EXPECT_EQ(missed({0, 1, 3, 4, 9}), "world_state of 0.040 s was missed: the next is of 0.060 s");
}

}  // namespace
}  // namespace scarab::experiment
