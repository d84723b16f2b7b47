#include "tools/search/run_directory.hpp"

#include <gmock/gmock.h>

#include "tests/support/files.hpp"
#include "tests/unit/search/description_text.hpp"

namespace scarab::search {
namespace {

class RunDirectoryTest : public testing::Test {
 protected:
  Problem problem(const std::string& from = "", const std::string& to = "") {
    const auto file = folder_ / "search.yaml";
    test::write_text(file, description_text(from, to));
    return Problem(file);
  }
  [[nodiscard]] RunDirectory directory() const { return RunDirectory(folder_ / "out"); }

 private:
  test::TemporaryDirectory folder_;
};

TEST_F(RunDirectoryTest, IsOfTheSearchThatClaimedIt) {
  const RunDirectory it = directory();
  it.claim(problem(), {1, 2, "search.yaml"}, false);
  EXPECT_EQ(it.identity().islands, 2U);
  EXPECT_NO_THROW(it.claim(problem(), {1, 2, "search.yaml"}, false));
  EXPECT_THROW(it.claim(problem(), {2, 2, "search.yaml"}, false), WrongDirectory);
  EXPECT_THROW(it.claim(problem(), {1, 1, "search.yaml"}, false), WrongDirectory);
}

TEST_F(RunDirectoryTest, RefusesAnotherDescriptionAndNamesWhatDiffers) {
  const RunDirectory it = directory();
  it.claim(problem(), {}, false);
  try {
    it.claim(problem("weight: 2", "weight: 3"), {}, false);
    FAIL() << "accepted";
  } catch (const WrongDirectory& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("identity/description.yaml differs"));
  }
  EXPECT_NO_THROW(it.claim(problem("weight: 2", "weight: 3"), {}, true)) << "fresh";
}

TEST_F(RunDirectoryTest, ForgetsTheEarlierSearchWhenFresh) {
  const RunDirectory it = directory();
  it.claim(problem(), {}, false);
  it.write_costs({{{1, 2}}});
  it.write("history.csv", "old");
  it.claim(problem(), {}, true);
  EXPECT_TRUE(it.read_costs().empty());
  EXPECT_FALSE(it.read("history.csv"));
}

TEST_F(RunDirectoryTest, ReadsTheCostsItWroteToTheLastBit) {
  const RunDirectory it = directory();
  it.claim(problem(), {}, false);
  const std::vector<GenerationCosts> costs = {{{0.1, 1.0 / 3}, {1e-9, 2}}, {{0.7, 5}, {1, 1}}};
  it.write_costs(costs);
  EXPECT_EQ(it.read_costs(), costs);
}

TEST_F(RunDirectoryTest, RefusesDamagedCosts) {
  const RunDirectory it = directory();
  it.claim(problem(), {}, false);
  for (const char* line : {"1,0,0,abc", "1,0,1,0.5", "0,0,0,0.5", "nonsense"}) {
    it.write("costs.csv", std::string("generation,island,candidate,cost\n") + line + "\n");
    EXPECT_THROW((void)it.read_costs(), WrongDirectory) << line;
  }
}

TEST_F(RunDirectoryTest, ReadsTheWinnerItWrote) {
  const RunDirectory it = directory();
  const Problem of = problem();
  it.claim(of, {}, false);
  EXPECT_FALSE(it.read_winner(of.space()));
  it.write_winner({7, 0.123456789, 0.9, {0.5, -1.25}}, of.space());
  const auto winner = it.read_winner(of.space());
  ASSERT_TRUE(winner);
  EXPECT_EQ(winner->generation, 7U);
  EXPECT_EQ(winner->objective, 0.123456789);
  EXPECT_EQ(winner->values, (std::vector<double>{0.5, -1.25}));
}

}  // namespace
}  // namespace scarab::search
