#include "tools/drive/line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scarab::drive {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Fit, CutsBetweenCharacters) {
  EXPECT_EQ(fit("behaviour", 4), "beha");
  EXPECT_EQ(fit("Käfer", 3), "Käf");
  EXPECT_EQ(fit("Käfer", 2), "Kä");
  EXPECT_EQ(fit("Käfer", 9), "Käfer");
  EXPECT_EQ(fit("x", 0), "");
}

TEST(Fit, LetsNoControlCharacterReachTheTerminal) {
  const std::string fitted = fit("a\x1b[2Jb\nc\x7f", 80);
  EXPECT_EQ(fitted, "a?[2Jb?c?");
}

TEST(Fit, CutsALineAcrossItsSpans) {
  const Line line = {{"abc", Style::kBold}, {"def"}, {"ghi"}};
  const Line cut = fit(line, 5);
  EXPECT_EQ(plain(cut), "abcde");
  EXPECT_EQ(cut[0].style, Style::kBold);
  EXPECT_EQ(plain(fit(line, 100)), "abcdefghi");
}

TEST(Padded, IsAsWideAsAsked) {
  EXPECT_EQ(padded("ab", 4), "ab  ");
  EXPECT_EQ(padded("abcdef", 4), "abcd");
  EXPECT_EQ(width(padded("Käfer", 9)), 9U);
}

std::size_t filled(const std::string& bar) {
  return static_cast<std::size_t>(std::count(bar.begin(), bar.end(), '#'));
}

TEST(Bar, GrowsWithItsValueAndKeepsItsWidth) {
  std::size_t before = 0;
  for (double value = -0.5; value < 1.5; value += 0.01) {
    const std::string text = bar(value, 0, 1, 0.5, 34);
    ASSERT_EQ(text.size(), 34U);
    ASSERT_GE(filled(text) + 1, before) << "the mark may hide one place";
    before = std::max(before, filled(text));
  }
  EXPECT_EQ(filled(bar(-3, 0, 1, 0.5, 34)), 0U);
  EXPECT_EQ(filled(bar(3, 0, 1, 0.5, 34)), 31U) << "all but the mark";
}

TEST(Bar, MarksItsThreshold) {
  for (const double mark : {0.0, 0.25, 0.5, 1.0, 7.0}) {
    const std::string text = bar(0.9, 0, 1, mark, 34);
    EXPECT_EQ(std::count(text.begin(), text.end(), '|'), 1);
  }
  EXPECT_EQ(bar(0.1, 0, 1, 0.5, 12).find('|'), 6U);
}

TEST(Bar, OutlivesValuesThatAreNotFinite) {
  for (const double value : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(filled(bar(value, 0, 1, 0.5, 20)), 0U);
    EXPECT_EQ(filled(signed_bar(value, 9)), 0U);
    EXPECT_EQ(figure(value, 2), "-");
  }
}

TEST(SignedBar, FillsTheSideOfItsSign) {
  EXPECT_EQ(signed_bar(0, 9), "[   |   ]");
  EXPECT_EQ(signed_bar(1, 9), "[   |###]");
  EXPECT_EQ(signed_bar(-1, 9), "[###|   ]");
  EXPECT_EQ(signed_bar(-0.34, 9), "[  #|   ]");
  EXPECT_EQ(signed_bar(-9, 9), "[###|   ]");
}

}  // namespace
}  // namespace scarab::drive
