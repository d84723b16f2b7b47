#include "common/config/schema.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "common/config/json.hpp"
#include "tests/unit/config/gait.hpp"

/// That a validator takes and refuses what the loader does: tests/integration/config.
namespace scarab::config {
namespace {

template <class T>
std::string shape_of(const Range& range = kAny) {
  T value{};
  return emit_json(schema_of(value, range).shape);
}

template <class T>
std::string needs_of() {
  T value{};
  return emit_json(schema_of(value).needs);
}

TEST(Schema, OfANumberHasItsRangeAndKeepsTheOpenEndOpen) {
  EXPECT_EQ(shape_of<double>(), R"({"type": "number"})"
                                "\n");
  EXPECT_EQ(shape_of<double>(kFraction), R"({"type": "number", "minimum": 0, "maximum": 1})"
                                         "\n");
  EXPECT_EQ(shape_of<double>(kPositive), R"({"type": "number", "exclusiveMinimum": 0})"
                                         "\n");
}

TEST(Schema, OfAnIntegerHasTheTypesLimitsUnlessTheRangeIsNarrower) {
  EXPECT_EQ(shape_of<std::int8_t>(), R"({"type": "integer", "minimum": -128, "maximum": 127})"
                                     "\n");
  EXPECT_EQ(shape_of<std::uint16_t>(), R"({"type": "integer", "minimum": 0, "maximum": 65535})"
                                       "\n");
  EXPECT_EQ(shape_of<int>(Range{1, 9}), R"({"type": "integer", "minimum": 1, "maximum": 9})"
                                        "\n");
  EXPECT_EQ(shape_of<unsigned>(Range{-5, 9}), R"({"type": "integer", "minimum": 0, "maximum": 9})"
                                              "\n");
  EXPECT_EQ(shape_of<std::uint64_t>(), R"({"type": "integer", "minimum": 0})"
                                       "\n");
  EXPECT_EQ(shape_of<std::int64_t>(), R"({"type": "integer"})"
                                      "\n");
}

TEST(Schema, OfAListHasItsElementsAndAFixedSize) {
  EXPECT_EQ(shape_of<std::vector<bool>>(), R"({"type": "array", "items": {"type": "boolean"}})"
                                           "\n");
  EXPECT_EQ((shape_of<std::array<double, 3>>(kFraction)),
            R"({"type": "array", "items": {"type": "number", "minimum": 0, "maximum": 1}, )"
            R"("minItems": 3, "maxItems": 3})"
            "\n");
}

TEST(Schema, OfAnEnumerationHasItsNames) {
  EXPECT_EQ(shape_of<gait::Kind>(), R"({"enum": ["tripod", "tetrapod", "wave"]})"
                                    "\n");
}

TEST(Schema, OfAStructKnowsNoOtherKeysAndNeedsItsOwn) {
  EXPECT_EQ(shape_of<gait::Leg>(), R"({
  "type": "object",
  "additionalProperties": false,
  "properties": {
    "length_m": {"type": "number", "exclusiveMinimum": 0, "description": "m, above 0"},
    "present": {"type": "boolean"}
  }
}
)");
  EXPECT_EQ(needs_of<gait::Leg>(), R"({"required": ["length_m", "present"]})"
                                   "\n");
}

TEST(Schema, OfAnOptionalTakesTheWordAbsent) {
  const std::string shape = shape_of<std::optional<double>>(kPositive);
  EXPECT_EQ(shape, R"({"anyOf": [{"const": "absent"}, {"type": "number", "exclusiveMinimum": 0}]})"
                   "\n");
  EXPECT_EQ(needs_of<std::optional<gait::Leg>>(), needs_of<gait::Leg>());
}

TEST(Schema, NeedsWholeElementsOfAListInAnyFile) {
  EXPECT_EQ(needs_of<std::vector<gait::Leg>>(), "null\n");
  EXPECT_NE(shape_of<std::vector<gait::Leg>>().find(R"({"required": ["length_m", "present"]})"),
            std::string::npos);
}

TEST(Schema, NeedsTheKeysOfEveryEntryOfAMap) {
  EXPECT_EQ((needs_of<std::map<std::string, gait::Leg>>()),
            R"({"additionalProperties": {"required": ["length_m", "present"]}})"
            "\n");
}

TEST(Schema, DoesNotNeedAnOptionalKeyAndTellsItsDefault) {
  EXPECT_EQ(needs_of<gait::Gait>().find("trim"), std::string::npos);
  EXPECT_NE(shape_of<gait::Gait>().find(R"("description": "in [-1, 1]", "default": 0.25)"),
            std::string::npos)
      << shape_of<gait::Gait>();
}

TEST(Schema, OfAFileNeedsNothingOnceItExtendsAnother) {
  const std::string text = schema<gait::Gait>("a gait");
  EXPECT_NE(text.find(R"("title": "a gait")"), std::string::npos);
  EXPECT_NE(text.find(R"("if": {"required": ["extends"]})"), std::string::npos);
  EXPECT_LT(text.find(R"("else": {)"), text.find(R"("required": ["name")")) << text;
}

}  // namespace
}  // namespace scarab::config
