#include "common/runtime/end_words.hpp"

#include <gtest/gtest.h>

namespace scarab::runtime {
namespace {

TEST(EndWords, ReasonComesBackOfTheSameTrialOnly) {
  const std::string said = end_words(3, {false, "operator stop: lunch"});
  EXPECT_EQ(said, "trial 3 ended: failure: operator stop: lunch");
  EXPECT_EQ(reason_in(said, 3), "operator stop: lunch");
  EXPECT_EQ(reason_in(said, 2), std::nullopt);
  EXPECT_EQ(reason_in(said, 33), std::nullopt);
  EXPECT_EQ(reason_in(end_words(4, {true, "the time limit"}), 4), "the time limit");
}

TEST(EndWords, MayFollowOtherWords) {
  const std::string said = "safe stop: too hot; " + end_words(3, {false, "time limit"});
  EXPECT_EQ(reason_in(said, 3), "time limit");
  EXPECT_EQ(reason_in("safe stop: too hot", 3), std::nullopt);
  EXPECT_EQ(reason_in("", 3), std::nullopt);
}

}  // namespace
}  // namespace scarab::runtime
