#include "common/config/json.hpp"

#include <gtest/gtest.h>

#include <string>

#include "common/config/document.hpp"

namespace scarab::config {
namespace {

std::string json_of(const std::string& yaml) { return emit_json(parse_text("x.yaml", yaml).root); }

TEST(Json, WritesNumbersAndTruthBareAndAllElseAsText) {
  EXPECT_EQ(json_of("[1, -2.5, 1e-9, true, false, absent, 'true', '7', yes]"),
            "[1, -2.5, 1e-9, true, false, \"absent\", \"true\", \"7\", \"yes\"]\n");
  EXPECT_EQ(json_of("a:\n"), "{\"a\": null}\n");
  EXPECT_EQ(json_of("{a: {}, b: []}"), "{\"a\": {}, \"b\": []}\n");
}

TEST(Json, EscapesQuotesBackslashesAndControlCharacters) {
  EXPECT_EQ(json_of(R"(['a"b', 'c\d', "e\nf\x01"])"), R"(["a\"b", "c\\d", "e\u000af\u0001"])"
                                                      "\n");
}

TEST(Json, BreaksLinesOnlyWhereOneIsTooLong) {
  const std::string word(70, 'w');
  EXPECT_EQ(
      json_of("{a: [1, 2], b: [" + word + ", " + word + "]}"),
      "{\n  \"a\": [1, 2],\n  \"b\": [\n    \"" + word + "\",\n    \"" + word + "\"\n  ]\n}\n");
}

}  // namespace
}  // namespace scarab::config
