#include "common/runtime/expectation.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace scarab::runtime {
namespace {

using testing::HasSubstr;
using testing::Pair;
using testing::UnorderedElementsAre;

std::string refusal(const std::string& text) {
  try {
    parse_expectation(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Expectation, NamesEachServiceWithItsCount) {
  EXPECT_THAT(parse_expectation("plant=1,premotor=2,logger=0"),
              UnorderedElementsAre(Pair("plant", 1), Pair("premotor", 2), Pair("logger", 0)));
}

TEST(Expectation, NothingIsExpectedOfNoText) { EXPECT_TRUE(parse_expectation("").empty()); }

TEST(Expectation, RefusalNamesThePartThatIsWrong) {
  for (const std::string part :
       {"premotor", "=1", "premotor=", "premotor=x", "premotor=1x", "premotor=-1", "premotor= 1",
        "premotor=1.5", "premotor=17", "premotor=99999999999999999999"}) {
    EXPECT_THAT(refusal("plant=1," + part), HasSubstr("'" + part + "'")) << part;
    EXPECT_THAT(refusal(part + ",plant=1"), HasSubstr("'" + part + "'")) << part;
  }
}

TEST(Expectation, RefusesAnEmptyPartInTheMiddle) {
  EXPECT_THAT(refusal("plant=1,,premotor=1"), HasSubstr("NAME=COUNT"));
}

TEST(Expectation, RefusesAServiceNamedTwice) {
  EXPECT_THAT(refusal("plant=1,plant=2"), HasSubstr("'plant=2': named twice"));
}

}  // namespace
}  // namespace scarab::runtime
