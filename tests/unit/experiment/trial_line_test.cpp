#include <gmock/gmock.h>

#include "common/config/error.hpp"
#include "services/experiment/config.hpp"
#include "tests/unit/experiment/trial_text.hpp"

namespace scarab::experiment {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(TrialLine, HasWhatTheTextSays) {
  const auto line = read_trial_line("line 1", trial_text());
  EXPECT_EQ(line.index, 7U);
  EXPECT_EQ(line.strategy, "soft+hard");
  EXPECT_EQ(line.goal, Goal::kAcross);
  EXPECT_EQ(line.height_m, 0.1);
  EXPECT_EQ(line.distance_m, 1.46);
  EXPECT_EQ(line.time_limit_s, 60);
  EXPECT_EQ(line.seed, 1000001U);
  EXPECT_EQ(line.perturb_position_m, 0.02);
  EXPECT_EQ(line.perturb_yaw_rad, 0.05235987755982988);
  EXPECT_EQ(line.perturb_friction, 0.1);
  EXPECT_TRUE(line.perturb_cpg_phase);
  EXPECT_EQ(line.friction_scale, 1);
  EXPECT_EQ(line.object_mass_kg, 2.5);
  EXPECT_EQ(line.object_diameter_m, 0);
}

TEST(TrialLine, MayLackItsIndexAlone) {
  EXPECT_EQ(read_trial_line("", trial_text_with(R"("index": 7, )", "")).index, std::nullopt);
  EXPECT_THROW(read_trial_line("", trial_text_with(R"("seed": 1000001, )", "")), config::Error);
}

TEST(TrialLine, KnowsEveryGoal) {
  for (const auto& [name, goal] : kGoalNames) {
    const auto text = trial_text_with("across", std::string(name));
    EXPECT_EQ(read_trial_line("", text).goal, goal) << name;
  }
}

TEST(TrialLine, TakesTheWholeRangeOfSeeds) {
  const auto text = trial_text_with("1000001", "18446744073709551615");
  EXPECT_EQ(read_trial_line("", text).seed, 18446744073709551615U);
}

TEST(TrialLine, TakesCompactJson) {
  std::string text;
  for (const char c : trial_text()) {
    if (c != ' ') text += c;
  }
  EXPECT_EQ(read_trial_line("", text).seed, 1000001U);
}

struct Bad {
  const char* name;
  std::string text;
  const char* says;
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

std::string name_of(const testing::TestParamInfo<Bad>& info) { return info.param.name; }

class BadTrialLine : public testing::TestWithParam<Bad> {};

TEST_P(BadTrialLine, IsRefusedInWords) {
  try {
    (void)read_trial_line("line 3", GetParam().text);
    FAIL() << "was taken";
  } catch (const config::Error& error) {
    EXPECT_THAT(error.what(), StartsWith("line 3:"));
    EXPECT_THAT(error.what(), HasSubstr(GetParam().says));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadTrialLine,
    testing::Values(
        Bad{"Nothing", "", "expected a map"}, Bad{"Words", "go", "expected a map"},
        Bad{"List", "[" + trial_text() + "]", "expected a map"},
        Bad{"Two", trial_text() + " " + trial_text(), "more than one"},
        Bad{"Torn", trial_text().substr(0, 60), "line 3:"},
        Bad{"MissingKey", trial_text_with(R"("goal": "across", )", ""), "goal: missing key"},
        Bad{"UnknownKey", trial_text_with("height_m", "hight_m"), "did you mean 'height_m'?"},
        Bad{"KeyTwice", trial_text_with("distance_m", "height_m"), "duplicate key"},
        Bad{"Goal", trial_text_with("across", "home"), "goal: expected one of travel, across"},
        Bad{"AcrossNothing", trial_text_with(R"("height_m": 0.1)", R"("height_m": 0)"),
            "goal: across needs an obstacle"},
        Bad{"NumberAsText", trial_text_with("1.46", R"("1.46")"), "distance_m: expected a number"},
        Bad{"NotFinite", trial_text_with("1.46", "NaN"), "distance_m: 'NaN' is not finite"},
        Bad{"Null", trial_text_with("1.46", "null"), "distance_m: expected a number"},
        Bad{"NegativeSeed", trial_text_with("1000001", "-1"), "seed: -1 is negative"},
        Bad{"BrokenSeed", trial_text_with("1000001", "1.5"), "seed: expected a whole number"},
        Bad{"Truth", trial_text_with("true", "1"), "perturb_cpg_phase: expected true or false"},
        Bad{"TimeLimit", trial_text_with("60.0", "0"), "time_limit_s: 0 is not in [0.1, 36000]"},
        Bad{"Height", trial_text_with("0.1,", "0.6,"), "height_m: 0.6 is not in [0, 0.5]"},
        Bad{"Friction", trial_text_with(R"("friction_scale": 1.0)", R"("friction_scale": -1)"),
            "friction_scale: -1 is not in"},
        Bad{"Mass", trial_text_with("2.5", "-2.5"), "object_mass_kg: -2.5 is not in"},
        Bad{"LongStrategy", trial_text_with("soft+hard", std::string(64, 's')),
            "strategy: is longer than 63 bytes"}),
    name_of);

}  // namespace
}  // namespace scarab::experiment
