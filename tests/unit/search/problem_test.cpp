#include "tools/search/problem.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "common/config/error.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/unit/search/description_text.hpp"

namespace scarab::search {
namespace {

class ProblemTest : public testing::Test {
 protected:
  Problem problem(const std::string& from = "", const std::string& to = "") {
    const auto file = folder_ / "search.yaml";
    test::write_text(file, description_text(from, to));
    return Problem(file);
  }
  /// What is said of the description with `from` replaced by `to`.
  std::string refusal(const std::string& from, const std::string& to) {
    try {
      (void)problem(from, to);
    } catch (const config::Error& error) {
      return std::string(error.what()).substr((folder_ / "search.yaml").string().size());
    }
    return "accepted";
  }

 private:
  test::TemporaryDirectory folder_;
};

TEST_F(ProblemTest, StartsAtTheBase) {
  const Problem it = problem();
  ASSERT_EQ(it.space().parameters().size(), 2U);
  for (const Parameter& parameter : it.space().parameters()) {
    EXPECT_EQ(parameter.start, it.base().number(parameter.path));
  }
}

TEST_F(ProblemTest, SetsValuesOverridesAndTies) {
  const Problem it = problem();
  const auto searched = it.tree({0.5, 1.25}, Fidelity::kSearch);  // in the order of the paths
  EXPECT_EQ(searched.number("plant.start.settle_s"), 0.5);
  EXPECT_EQ(searched.number("premotor.motor.front.t_gain_rad"), 1.25);
  EXPECT_EQ(searched.number("plant.start.front_rad.0"),
            searched.number("premotor.motor.front.t_offset_rad"));
  EXPECT_EQ(searched.build().plant.timing.step_s, 0.004);
}

TEST_F(ProblemTest, OverridesWhileSearchingOnly) {
  const Problem it = problem();
  const auto full = it.tree({0.5, 1.25}, Fidelity::kFull);
  EXPECT_EQ(full.number("plant.timing.step_s"), it.base().number("plant.timing.step_s"));
  EXPECT_EQ(full.number("plant.start.settle_s"), 0.5);
}

TEST_F(ProblemTest, RefusesAPathThatLeadsNowhere) {
  EXPECT_THAT(refusal("premotor.motor.front.t_gain_rad", "premotor.motor.front.gain"),
              testing::StartsWith(":10:30: parameters.premotor.motor.front.gain: no number"));
  EXPECT_THAT(refusal("plant.timing.step_s", "plant.timing"),
              testing::HasSubstr("overrides.plant.timing: no number"));
  EXPECT_THAT(refusal("plant.start.front_rad.0", "plant.start.front_rad.3"),
              testing::HasSubstr("ties.plant.start.front_rad.3: no number"));
}

TEST_F(ProblemTest, RefusesAnIntervalAwayFromTheBase) {
  EXPECT_THAT(refusal("low: 0, high: 2", "low: 5, high: 6"),
              testing::HasSubstr("outside of the interval"));
}

TEST_F(ProblemTest, RefusesAnIntervalThatTheServicesWouldRefuse) {
  EXPECT_THAT(refusal("{low: 0, high: 2}", "{low: -1, high: 2}"),
              testing::HasSubstr("its end -1 is refused: "));
}

TEST_F(ProblemTest, RefusesAParameterThatIsTiedOrOverridden) {
  EXPECT_THAT(refusal("plant.start.front_rad.0:", "plant.start.settle_s:"),
              testing::HasSubstr("ties.plant.start.settle_s: is a parameter, too"));
  EXPECT_THAT(refusal("plant.timing.step_s:", "plant.start.settle_s:"),
              testing::HasSubstr("overrides.plant.start.settle_s: is a parameter, too"));
}

TEST_F(ProblemTest, RefusesAStrategyThatTheSupervisorDoesNotKnow) {
  EXPECT_THAT(refusal("strategy: soft,", "strategy: sofd,"),
              testing::HasSubstr("scenarios[0].strategy: "));
}

TEST(ShippedSearch, FitsTheShippedFiles) {
  int read = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_file("config/search"))) {
    EXPECT_NO_THROW((void)Problem(entry.path())) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 1);
}

}  // namespace
}  // namespace scarab::search
