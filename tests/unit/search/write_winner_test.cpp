#include "tools/search/write_winner.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "services/premotor/config.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/unit/search/description_text.hpp"

namespace scarab::search {
namespace {

class WriteWinner : public testing::Test {
 protected:
  WriteWinner() {
    test::write_text(folder_ / "search.yaml", description_text());
    problem_.emplace(folder_ / "search.yaml");
    directory_.claim(*problem_, {3, 1, folder_ / "search.yaml"}, false);
    directory_.write_winner({7, 0.5, 0.9, {0.75, 1.2345}}, problem_->space());
  }
  std::string written(const std::string& kind) {
    (void)write_winner(*problem_, directory_, folder_ / "config");
    return test::read_text(folder_ / "config" / kind / "beetle.yaml");
  }

  test::TemporaryDirectory folder_;
  std::optional<Problem> problem_;
  RunDirectory directory_{folder_ / "out"};
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_F(WriteWinner, ChangesOneLineForOneValueAndSaysWhereItIsFrom) {
  const auto before = lines_of(test::read_text(test::source_file("config/premotor/beetle.yaml")));
  auto after = lines_of(written("premotor"));
  const auto end = std::find(after.begin(), after.end(), "# (written by scarab-search write)");
  ASSERT_NE(end, after.end());
  EXPECT_THAT(std::vector<std::string>(after.begin(), end),
              testing::Contains(testing::HasSubstr("--seed 3 --islands 1")));
  const auto tail = std::vector<std::string>(end + 1, after.end());
  std::vector<std::string> changed;
  for (const std::string& line : tail) {
    if (std::find(before.begin(), before.end(), line) == before.end()) changed.push_back(line);
  }
  EXPECT_THAT(changed, testing::ElementsAre(testing::HasSubstr("t_gain_rad: 1.2345")));
}

TEST_F(WriteWinner, LoadsStrictlyAndHasTheValues) {
  (void)written("premotor");
  const auto config = premotor::load_config(folder_ / "config" / "premotor" / "beetle.yaml");
  EXPECT_EQ(config.motor.front.t_gain_rad, 1.2345);
}

TEST_F(WriteWinner, WritesWhatIsTiedToo) {
  test::write_text(folder_ / "search.yaml",
                   description_text("plant.start.front_rad.0: premotor.motor.front.t_offset_rad",
                                    "supervisor.as.drop_rad: plant.start.settle_s"));
  const Problem tied(folder_ / "search.yaml");
  directory_.claim(tied, {3, 1, folder_ / "search.yaml"}, true);
  directory_.write_winner({7, 0.5, 0.9, {0.75, 1.2345}}, tied.space());
  (void)write_winner(tied, directory_, folder_ / "config");
  EXPECT_THAT(test::read_text(folder_ / "config/plant/beetle.yaml"),
              testing::HasSubstr("  settle_s: 0.75 "));
  EXPECT_THAT(test::read_text(folder_ / "config/supervisor/beetle.yaml"),
              testing::HasSubstr("  drop_rad: 0.75 "));
}

TEST_F(WriteWinner, TwiceIsAsOnce) {
  const std::string once = written("premotor");
  EXPECT_EQ(written("premotor"), once);
}

TEST_F(WriteWinner, CarriesTheHeldOutTable) {
  directory_.write("held_out.txt", "held-out seeds 1..2\nflat 40/40\n");
  EXPECT_THAT(written("premotor"), testing::HasSubstr("#   flat 40/40\n"));
}

TEST_F(WriteWinner, RefusesABaseThatHasChangedOtherwise) {
  std::string text = *directory_.read("identity/premotor.yaml");
  const std::string number = "middle_bias: ";
  text.insert(text.find(number) + number.size(), "1");
  directory_.write("identity/premotor.yaml", text);
  EXPECT_THROW((void)write_winner(*problem_, directory_, folder_ / "config"), WrongDirectory);
}

}  // namespace
}  // namespace scarab::search
