#include <gmock/gmock.h>

#include <cstdlib>
#include <vector>

#include "services/experiment/config.hpp"
#include "tests/unit/experiment/trial_text.hpp"

namespace scarab::experiment {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

Outcome outcome() {
  Outcome outcome;
  outcome.success = outcome.judged = true;
  outcome.reason = "the object's axis is past";
  outcome.end.time_s = 38.2;
  outcome.end.wall_s = 0.123;
  outcome.measures.object_travel_m = 0.1 + 0.2;
  outcome.measures.object_sideways_m = -1e-17;
  outcome.measures.trunk_travel_m = 1.0 / 3;
  outcome.measures.heading_rad = -6.5;
  outcome.measures.heading_max_rad = 7;
  outcome.measures.climb_s = 2.1;
  return outcome;
}

std::string row_with(double number) {
  auto changed = outcome();
  changed.measures.heading_rad = number;
  return result_row(read_trial_line("", trial_text()), changed);
}

double heading_of(const std::string& row) {
  const std::string key = "\"heading_rad\": ";
  return std::strtod(row.c_str() + row.find(key) + key.size(), nullptr);
}

TEST(ResultRow, HasEveryColumnInItsOrder) {
  EXPECT_EQ(result_row(read_trial_line("", trial_text()), outcome()),
            R"({"index": 7, "strategy": "soft+hard", "goal": "across", "height_m": 0.1, )"
            R"("distance_m": 1.46, "time_limit_s": 60, "seed": 1000001, )"
            R"("perturb_position_m": 0.02, "perturb_yaw_rad": 0.05235987755982988, )"
            R"("perturb_friction": 0.1, "perturb_cpg_phase": true, "friction_scale": 1, )"
            R"("object_mass_kg": 2.5, "object_diameter_m": 0, "success": true, "time_s": 38.2, )"
            R"("reason": "the object's axis is past", "object_travel_m": 0.30000000000000004, )"
            R"("object_sideways_m": -1e-17, "trunk_travel_m": 0.3333333333333333, )"
            R"("heading_rad": -6.5, "heading_max_rad": 7, "climb_s": 2.1, "mode1_s": null, )"
            R"("mode2_s": null})");
}

TEST(ResultRow, BeginsWithItsTrialAgain) {
  const auto row = row_with(0);
  const auto trial = row.substr(0, row.find(R"(, "success")")) + "}";
  const auto again = result_row(read_trial_line("", trial), outcome());
  EXPECT_EQ(again, result_row(read_trial_line("", trial_text()), outcome()));
}

TEST(ResultRow, NumbersComeBackExactly) {
  for (const double number : {0.1, 1.0 / 3, 1e-300, 123456789.123456789, 5e-324, -0.7, 1e22, 3.0}) {
    EXPECT_EQ(heading_of(row_with(number)), number) << row_with(number);
  }
}

TEST(ResultRow, LeavesOutAMissingIndex) {
  const auto text = trial_text_with(R"("index": 7, )", "");
  EXPECT_THAT(result_row(read_trial_line("", text), outcome()), Not(HasSubstr("index")));
}

TEST(ResultRow, DoesNotSayWhatDiffersBetweenEqualTrials) {
  auto slow = outcome();
  slow.end.wall_s = 99;
  slow.number = 12;
  const auto line = read_trial_line("", trial_text());
  EXPECT_EQ(result_row(line, slow), result_row(line, outcome()));
}

TEST(ResultRow, IsOneLineWhateverTheReason) {
  auto awkward = outcome();
  awkward.reason = "a \"quoted\"\nword \\ and more";
  const auto row = result_row(read_trial_line("", trial_text()), awkward);
  EXPECT_THAT(row, HasSubstr(R"("a \"quoted\"\u000aword \\ and more")"));
}

TEST(ErrorRow, NamesTheTrialIfThereIsOne) {
  EXPECT_EQ(error_row(3, "plant/0 is gone"), R"({"index": 3, "error": "plant/0 is gone"})");
  EXPECT_EQ(error_row(std::nullopt, "no"), R"({"error": "no"})");
}

}  // namespace
}  // namespace scarab::experiment
