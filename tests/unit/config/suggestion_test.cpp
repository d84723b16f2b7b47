#include "common/config/suggestion.hpp"

#include <gtest/gtest.h>

namespace scarab::config {
namespace {

TEST(EditDistance, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("abc", "abc"), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("lenght", "length"), 1U) << "swapped neighbours are one edit";
}

TEST(EditDistance, IsSymmetric) {
  for (const char* a : {"tibia", "femur", "coxa", "shoulder"}) {
    for (const char* b : {"tiba", "femora", "", "soulder"}) {
      EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
    }
  }
}

TEST(Closest, IsTheNearestIfItIsNear) {
  const std::vector<std::string_view> names = {"length_m", "radius_m", "mass_kg"};
  EXPECT_EQ(closest("lenght_m", names), "length_m");
  EXPECT_EQ(closest("mass", names), std::nullopt) << "three of four letters would be new";
  EXPECT_EQ(closest("mass_g", names), "mass_kg");
  EXPECT_EQ(closest("colour", names), std::nullopt);
  EXPECT_EQ(closest("x", {}), std::nullopt);
}

TEST(Closest, DoesNotTurnShortNamesIntoEachOther) {
  EXPECT_EQ(closest("kp", {"x", "y"}), std::nullopt);
}

}  // namespace
}  // namespace scarab::config
