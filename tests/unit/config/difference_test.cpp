#include "tools/config/difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/config/document.hpp"

namespace scarab::config_tool {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> between(const std::string& a, const std::string& b) {
  return differences(config::parse_text("a", a).root, config::parse_text("b", b).root);
}

TEST(Differences, AreNoneBetweenTheSameValues) {
  const std::string text = "a: 1\nb: {c: [1, 2], d: absent}\n";
  EXPECT_THAT(between(text, text), IsEmpty());
  EXPECT_THAT(between(text, "b:\n  d: absent\n  c: [1, 2]\na: 1\n"), IsEmpty()) << "order of keys";
}

TEST(Differences, NameThePathAndBothValues) {
  EXPECT_THAT(between("a: {b_m: 1, c: x}\n", "a: {b_m: 2, c: y}\n"),
              ElementsAre("a.b_m: 1 -> 2", "a.c: x -> y"));
}

TEST(Differences, ShowListsWhole) {
  EXPECT_THAT(between("a: [1, 2]\n", "a: [1, 3]\n"), ElementsAre("a: [1, 2] -> [1, 3]"));
  EXPECT_THAT(between("a: []\n", "a: [{b: 1}]\n"), ElementsAre("a: [] -> [{b: 1}]"));
}

TEST(Differences, ShowWhatOnlyOneHas) {
  EXPECT_THAT(between("a: {b: 1, c: 2}\n", "a: {b: 1, d: {e: 3}}\n"),
              ElementsAre("a.c: 2 -> (none)", "a.d: (none) -> {e: 3}"));
}

TEST(Differences, ShowAMapThatBecomesAWord) {
  EXPECT_THAT(between("a: {b: 1}\n", "a: absent\n"), ElementsAre("a: {b: 1} -> absent"));
}

TEST(Differences, TellTextFromNumbers) {
  EXPECT_THAT(between("a: 1\n", "a: '1'\n"), ElementsAre("a: 1 -> \"1\""));
}

}  // namespace
}  // namespace scarab::config_tool
