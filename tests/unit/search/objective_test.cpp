#include "tools/search/objective.hpp"

#include <gmock/gmock.h>

#include "tests/unit/search/description_text.hpp"
#include "tools/search/history.hpp"

namespace scarab::search {
namespace {

/// Scenario 0 `flat` has weight 1, scenario 1 `wall` weight 2; both a limit of 60 s.
const Plan kPlan = {{0, 1}, {0, 2}, {1, 1}, {1, 2}};

Measure success(double time_s) {
  Measure measure;
  measure.success = true;
  measure.time_s = time_s;
  return measure;
}

Score scored(const Measures& measures) {
  return score(description_from(description_text()), kPlan, measures);
}

TEST(Objective, IsTheWeightedMeanOfTheScenariosMeanCosts) {
  const Score result = scored({success(6), success(18), success(30), success(30)});
  EXPECT_DOUBLE_EQ(result.scenarios[0].cost, 0.2);
  EXPECT_DOUBLE_EQ(result.scenarios[1].cost, 0.5);
  EXPECT_DOUBLE_EQ(result.objective, (0.2 + 2 * 0.5) / 3);
}

TEST(Objective, CountsSuccessesAndTheirTimes) {
  const Score result = scored({success(6), Measure{}, success(20), success(30)});
  EXPECT_EQ(result.scenarios[0].successes, 1U);
  EXPECT_EQ(result.scenarios[0].trials, 2U);
  EXPECT_DOUBLE_EQ(result.scenarios[0].time_s, 6);
  EXPECT_DOUBLE_EQ(result.scenarios[1].time_s, 25);
}

TEST(Objective, AddsAPenaltyAveragedLikeTheCosts) {
  Measures measures(4, success(30));
  const double without = scored(measures).objective;
  measures[0].leg_leg_share = 0.3;  // half way from bound to worst, one of two trials of weight 1/3
  EXPECT_NEAR(scored(measures).objective - without, 0.5 * 0.5 / 2 / 3, 1e-12);
}

TEST(Objective, AddsWhatAnOrderIsAmiss) {
  const auto order_term = [](double flat_s, double wall_s) {
    return scored({success(flat_s), success(flat_s), success(wall_s), success(wall_s)})
        .terms.back()
        .value;
  };
  EXPECT_EQ(order_term(20, 30), 0) << "faster by more than the margin, 6 s";
  EXPECT_DOUBLE_EQ(order_term(30, 30), 0.25 * 0.1);
  EXPECT_DOUBLE_EQ(order_term(42, 30), 0.25 * 0.3);
}

/// Else a candidate would keep an order by letting the slower one fail now and then.
TEST(Objective, AFailureIsNoSlowArrival) {
  const auto order_term = [](const Measures& measures) { return scored(measures).terms.back(); };
  const auto all = order_term({success(30), success(30), success(30), success(30)});
  const auto some = order_term({success(30), success(30), success(30), Measure{}});
  EXPECT_EQ(some.value, all.value);
  EXPECT_EQ(some.measured, all.measured);
  EXPECT_DOUBLE_EQ(order_term({success(30), success(30), Measure{}, Measure{}}).value, 0.25);
  EXPECT_DOUBLE_EQ(order_term({Measure{}, Measure{}, success(30), success(30)}).value, 0.25);
}

TEST(Objective, IsTheSumOfWhatItPrints) {
  Measures measures(4, success(42));
  measures[1].leg_leg_share = 0.4;
  measures[2] = Measure{};
  const Score result = scored(measures);
  double sum = (result.scenarios[0].cost + 2 * result.scenarios[1].cost) / 3;
  for (const AddedTerm& term : result.terms) sum += term.value;
  EXPECT_DOUBLE_EQ(result.objective, sum);
  const std::string table = score_table(result);
  for (const char* part : {"flat", "wall", "leg_leg_share", "flat < wall", "objective"}) {
    EXPECT_THAT(table, testing::HasSubstr(part));
  }
}

TEST(History, HasAColumnForEachPartAndRowsThatCanBeCutOff) {
  const Score one = scored(Measures(4, success(30)));
  const std::string header = history_header(one);
  const std::string first = history_line({1, 0, 6, 24, 0.1, {one, one}});
  const std::string second = history_line({2, 0, 12, 48, 0.1, {one}});
  const auto commas = [](const std::string& text) {
    return std::count(text.begin(), text.end(), ',');
  };
  EXPECT_EQ(commas(header), commas(first));
  EXPECT_EQ(history_until(header + first + second, 1), header + first);
  EXPECT_EQ(history_until(header + first + second, 2), header + first + second);
  EXPECT_EQ(history_until("", 2), "");
}

}  // namespace
}  // namespace scarab::search
