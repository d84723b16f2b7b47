#include <gtest/gtest.h>

#include <string>

#include "tests/unit/config/gait.hpp"

namespace scarab::gait {
namespace {

Gait read(const std::string& text) { return config::load_text<Gait>("dump", text); }

TEST(Dump, IsReadableYaml) {
  EXPECT_EQ(config::dump(read(kGood)), R"(name: walk
kind: wave
frequency_hz: 1.5
offset: -2
legs: 2
seed: 18446744073709551615
phases: [0, 0.25, 0.5]
weights: [0.001, -2]
order: [2, 1]
parts:
  left:
    length_m: 0.3
    present: true
  right:
    length_m: 0.4
    present: false
tail: absent
spares:
  - length_m: 0.1
    present: true
trim: 0.25
)");
}

TEST(Dump, ReadsBackToTheSameDump) {
  Gait gait = read(kGood);
  gait.tail = Leg{1.0 / 3.0, true};
  gait.spares.clear();
  gait.parts.clear();
  gait.frequency_hz = 0.1 + 0.2;
  const Gait again = read(config::dump(gait));
  EXPECT_EQ(again.frequency_hz, gait.frequency_hz);
  EXPECT_EQ(again.tail->length_m, 1.0 / 3.0);
  EXPECT_EQ(config::dump(again), config::dump(gait));
}

TEST(Dump, KeepsNestedLists) {
  using Table = std::map<std::string, std::vector<std::vector<std::vector<double>>>>;
  const Table table = {{"a", {{{1, 2}, {}}, {}, {{0.5}}}}, {"b", {}}};
  EXPECT_EQ(config::load_text<Table>("dump", config::dump(table)), table);
}

TEST(Dump, KeepsTextAsItIs) {
  for (const std::string text : {"",         "null",      "~",
                                 "true",     "absent",    "1.5",
                                 "010",      "a: b",      "# not a comment",
                                 "it's",     "\"",        "a\\b",
                                 " leading", "trailing ", "two\nlines",
                                 "tab\t",    "- dash",    "[1]",
                                 "{a: 1}",   "&a",        "*a",
                                 "!t",       "%d",        "@at",
                                 "`b",       "é",         "soft+hard",
                                 "\x01",     ".nan",      "?"}) {
    Gait gait = read(kGood);
    gait.name = text;
    gait.parts = {{text, Leg{0.5, true}}};
    const Gait again = read(config::dump(gait));
    EXPECT_EQ(again.name, text);
    EXPECT_EQ(again.parts.count(text), 1U) << text;
  }
}

}  // namespace
}  // namespace scarab::gait
