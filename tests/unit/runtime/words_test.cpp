#include "common/runtime/words.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace scarab::runtime {
namespace {

/// Each value up to `last` has a word, and its own.
template <class Enum>
void expect_words_up_to(Enum last) {
  std::set<std::string> words;
  for (int value = 0; value <= static_cast<int>(last); ++value) {
    const std::string text = word(static_cast<Enum>(value));
    EXPECT_NE(text, "unknown") << value;
    EXPECT_TRUE(words.insert(text).second) << text;
  }
}

TEST(Words, AreThereForEachValueAndDifferent) {
  expect_words_up_to(scarab_PHASE_FAILED);
  expect_words_up_to(scarab_BEHAVIOUR_MANUAL);
  expect_words_up_to(scarab_TRIGGER_FOOT_FORCE);
  expect_words_up_to(scarab_LIFECYCLE_FINALISED);
  expect_words_up_to(scarab_HEALTH_FAULT);
}

}  // namespace
}  // namespace scarab::runtime
