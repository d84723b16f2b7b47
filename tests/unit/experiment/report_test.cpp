#include "services/experiment/core/report.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace scarab::experiment {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Outcome outcome_of(bool success, double time_s, const std::string& reason = "across") {
  Outcome outcome;
  outcome.number = 3;
  outcome.strategy = "soft+hard";
  outcome.height_m = 0.1;
  outcome.seed = 42;
  outcome.success = success;
  outcome.reason = reason;
  outcome.end = {time_s, time_s / 40, 0.5, "done"};
  return outcome;
}

/// A plain reader of RFC 4180: rows of fields.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& field = rows.back().back();
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      field += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\n') {
      rows.push_back({""});
    } else {
      field += c;
    }
  }
  rows.pop_back();  // after the last line's end
  return rows;
}

TEST(Report, ResultLineSaysVerdictTimeReasonAndHowToRepeatIt) {
  const auto line = result_line(outcome_of(false, 12.34, "the robot overturned"));
  EXPECT_THAT(line, StartsWith("result: failure after 12.3 s: the robot overturned"));
  EXPECT_THAT(line, HasSubstr("soft+hard"));
  EXPECT_THAT(line, HasSubstr("obstacle 0.10 m"));
  EXPECT_THAT(line, HasSubstr("seed 42"));
  EXPECT_THAT(line, HasSubstr("40.0 x real time"));
  EXPECT_THAT(result_line(outcome_of(true, 1)), StartsWith("result: success"));
}

TEST(Report, ResultLineWithoutObstacle) {
  auto outcome = outcome_of(true, 5);
  outcome.height_m = 0;
  EXPECT_THAT(result_line(outcome), HasSubstr("no obstacle"));
}

TEST(Report, LinesAreSingleLines) {
  const auto outcome = outcome_of(true, 5);
  for (const auto& line : {result_line(outcome), summary_line({outcome}),
                           progress_line(outcome.end), change_line({1.5, "climb", "BS"})}) {
    EXPECT_THAT(line, Not(HasSubstr("\n")));
  }
}

TEST(Report, SpeedOfATrialThatHasJustBegunIsNotInfinite) {
  EXPECT_THAT(progress_line({0, 0, 0, "idle"}), HasSubstr("0.0 x real time"));
}

TEST(Report, SummaryCountsSuccessesAndGivesTheirTimes) {
  const auto line = summary_line(
      {outcome_of(true, 20), outcome_of(false, 60), outcome_of(true, 10), outcome_of(true, 40)});
  EXPECT_THAT(line, HasSubstr("3 of 4 trials succeeded"));
  EXPECT_THAT(line, HasSubstr("10.0 to 40.0 s"));
  EXPECT_THAT(line, HasSubstr("median 20.0 s"));
}

TEST(Report, MedianOfAnEvenNumberIsTheMiddle) {
  EXPECT_THAT(summary_line({outcome_of(true, 30), outcome_of(true, 10)}),
              HasSubstr("median 20.0 s"));
}

TEST(Report, SummaryWithoutASuccessGivesNoTimes) {
  EXPECT_EQ(summary_line({outcome_of(false, 60)}), "summary: 0 of 1 trials succeeded");
}

TEST(Report, AllSucceededOnlyWithoutAFailure) {
  EXPECT_TRUE(all_succeeded({outcome_of(true, 1), outcome_of(true, 2)}));
  EXPECT_FALSE(all_succeeded({outcome_of(true, 1), outcome_of(false, 2)}));
}

TEST(ResultsCsv, HasAHeaderAndARowATrial) {
  const auto rows = parse_csv(results_csv({outcome_of(true, 20.5), outcome_of(false, 60)}));
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) -
                                    rows[0].begin());
  };
  ASSERT_LT(column("seed"), rows[0].size());
  EXPECT_EQ(rows[1].at(column("trial")), "3");
  EXPECT_EQ(rows[1].at(column("strategy")), "soft+hard");
  EXPECT_EQ(rows[1].at(column("seed")), "42");
  EXPECT_EQ(rows[1].at(column("success")), "1");
  EXPECT_EQ(rows[2].at(column("success")), "0");
  EXPECT_EQ(std::stod(rows[1].at(column("time_s"))), 20.5);
  EXPECT_EQ(rows[2].at(column("reason")), "across");
}

TEST(ResultsCsv, AwkwardTextComesBackAsItWas) {
  for (const std::string reason : {"a, b", "\"quoted\"", "two\nlines", "\"", ",", "", "plain"}) {
    const auto rows = parse_csv(results_csv({outcome_of(false, 1, reason)}));
    ASSERT_EQ(rows.size(), 2U) << reason;
    ASSERT_EQ(rows[1].size(), rows[0].size()) << reason;
    EXPECT_EQ(rows[1].back(), reason);
  }
}

TEST(ResultsCsv, ListsTheChangesOfBehaviour) {
  auto outcome = outcome_of(true, 20);
  outcome.changes = {{0, "approach", ""}, {2.5, "climb", ""}};
  EXPECT_THAT(results_csv({outcome}), HasSubstr("approach 0.0; climb 2.5"));
}

}  // namespace
}  // namespace scarab::experiment
