#include "tools/search/description.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "common/config/error.hpp"
#include "tests/support/files.hpp"
#include "tests/support/programs.hpp"
#include "tests/unit/search/description_text.hpp"

namespace scarab::search {
namespace {

struct Wrong {
  const char* from;
  const char* to;
  const char* place;  ///< the text that begins where the error is said to be
  const char* message;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.to; }

const Wrong kWrong[] = {
    {"title:", "titel:", "titel", "titel: unknown key; did you mean 'title'?"},
    {"seeds: 2", "seeds: 0", "0, weight: 1}", "scenarios[0].seeds: 0 is not in [1, 10000]"},
    {"goal: travel", "goal: traval", "traval", "scenarios[0].goal: expected one of"},
    {"goal: travel", "goal: across", "across, time", "scenarios[0].goal: across needs an obstacle"},
    {"name: wall", "name: flat", "- {name: flat", "scenarios: two are named 'flat'"},
    {"high: 5", "high: -5", "-5}",
     "parameters.premotor.motor.front.t_gain_rad.high: must be above low"},
    {"bound: 0.1", "bound: 0.6", "0.5, weight",
     "penalties.leg_leg_share.worst: must be above bound"},
    {"slower: wall", "slower: all", "- {faster", "orders: no scenario 'all'"},
    {"last: 899999", "last: 2000010", "2000010", "seeds.search.last: must be below 1000000"},
    {"first: 2000001", "first: 5", "5, last: 2000040",
     "seeds.held_out.first: must be above 1000000"},
    {"last: 899999", "last: 900001", "{first: 900001", "seeds.validation: overlaps with the seeds"},
    {"first: 900001", "first: 900005", "900004", "seeds.validation.last: must not be below first"},
    {"population: 6", "population: 4", "4, sigma", "optimiser.population: 4 is not in [5, 1000]"},
};

/// `line:column` of a piece of the text.
std::string position_of(const std::string& text, const std::string& piece) {
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::invalid_argument("not in the text: " + piece);
  const auto begin = text.begin();
  const auto line = 1 + std::count(begin, begin + static_cast<std::ptrdiff_t>(at), '\n');
  return std::to_string(line) + ":" + std::to_string(at - text.rfind('\n', at));
}

class WrongDescription : public testing::TestWithParam<Wrong> {};

TEST_P(WrongDescription, IsRefusedAtItsPlace) {
  const Wrong& wrong = GetParam();
  const std::string text = description_text(wrong.from, wrong.to);
  try {
    (void)description_from(text);
    FAIL() << wrong.to << " was read";
  } catch (const config::Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("search.yaml:" + position_of(text, wrong.place) +
                                                  ": " + wrong.message));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, WrongDescription, testing::ValuesIn(kWrong));

TEST(Description, ReadsWhatItDumps) {
  const std::string dumped = dump_description(description_from(description_text()));
  EXPECT_EQ(dump_description(description_from(dumped)), dumped);
}

TEST(Description, HasTheSchemaThatIsShipped) {
  EXPECT_EQ(test::read_text(test::source_file("config/schema/search.json")), description_schema())
      << "run: scarab-search schema > config/schema/search.json";
}

}  // namespace
}  // namespace scarab::search
