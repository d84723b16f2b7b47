#include "tools/search/scalar_edit.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace scarab::search {
namespace {

constexpr const char* kText =
    "# yaml-language-server: $schema=x\n"
    "# What it is.\n"
    "\n"
    "front:\n"
    "  gain: 1.49         # [F] found\n"
    "  pose: [0.1, 0.2, 0.3]  # T, C, F\n"
    "last: 4.0\n";

TEST(ScalarEdit, ChangesNothingElse) {
  EXPECT_EQ(edit_scalars(kText, {}), kText);
  EXPECT_EQ(edit_scalars(kText, {{{7, 7}, "4.0", "5"}}),
            "# yaml-language-server: $schema=x\n"
            "# What it is.\n"
            "\n"
            "front:\n"
            "  gain: 1.49         # [F] found\n"
            "  pose: [0.1, 0.2, 0.3]  # T, C, F\n"
            "last: 5\n");
}

TEST(ScalarEdit, KeepsACommentInItsColumn) {
  using testing::HasSubstr;
  EXPECT_THAT(edit_scalars(kText, {{{5, 9}, "1.49", "-1.4923"}}),
              HasSubstr("\n  gain: -1.4923      # [F] found\n"));
  EXPECT_THAT(edit_scalars(kText, {{{5, 9}, "1.49", "2"}}),
              HasSubstr("\n  gain: 2            # [F] found\n"));
  EXPECT_THAT(edit_scalars(kText, {{{5, 9}, "1.49", "1.2345678901234567"}}),
              HasSubstr("\n  gain: 1.2345678901234567  # [F] found\n"));
}

TEST(ScalarEdit, ChangesSeveralOfALine) {
  EXPECT_THAT(edit_scalars(kText, {{{6, 10}, "0.1", "-0.15"}, {{6, 20}, "0.3", "7"}}),
              testing::HasSubstr("\n  pose: [-0.15, 0.2, 7]  # T, C, F\n"));
}

TEST(ScalarEdit, RefusesAnotherTextThanItWasTold) {
  EXPECT_THROW((void)edit_scalars(kText, {{{5, 9}, "1.50", "2"}}), std::invalid_argument);
  EXPECT_THROW((void)edit_scalars(kText, {{{70, 9}, "1.49", "2"}}), std::invalid_argument);
  EXPECT_THROW((void)edit_scalars(kText, {{{3, 9}, "1.49", "2"}}), std::invalid_argument);
}

TEST(Provenance, StandsBelowTheFirstLineOnce) {
  const std::string once = with_provenance(kText, {"#   first"});
  EXPECT_EQ(once.find("# yaml-language-server"), 0U);
  EXPECT_THAT(once, testing::HasSubstr("#   first\n"));
  EXPECT_THAT(once, testing::EndsWith(std::string(kText).substr(34)));
  const std::string twice = with_provenance(once, {"#   second", "#   third"});
  EXPECT_THAT(twice, testing::Not(testing::HasSubstr("first")));
  EXPECT_EQ(with_provenance(twice, {"#   first"}), once);
}

}  // namespace
}  // namespace scarab::search
