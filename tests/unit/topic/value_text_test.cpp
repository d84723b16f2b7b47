#include "tools/topic/value_text.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "common/config/error.hpp"

namespace scarab::topic {
namespace {

using testing::ElementsAre;
using Kind = sample::WrittenValue::Kind;

std::vector<std::string> documents(const std::string& text) {
  DocumentSplitter splitter;
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (auto document = splitter.add(line)) out.push_back(*document);
  }
  if (auto document = splitter.finish()) out.push_back(*document);
  return out;
}

TEST(DocumentSplitter, EndsYamlAtItsMarks) {
  EXPECT_THAT(documents("a: 1\nb: 2\n---\na: 3\n...\na: 4"),
              ElementsAre("a: 1\nb: 2\n", "a: 3\n", "a: 4\n"));
  EXPECT_THAT(documents("---\na: 1\n---\n---\n\n# nothing\n"), ElementsAre("a: 1\n"));
  EXPECT_THAT(documents(""), ElementsAre());
}

TEST(DocumentSplitter, EndsJsonAtItsLastBracket) {
  EXPECT_THAT(documents("{\"a\": 1}\n{\"a\":\n [2, {}]}\n{}\n"),
              ElementsAre("{\"a\": 1}\n", "{\"a\":\n [2, {}]}\n", "{}\n"));
  // Brackets and quotes within text are no brackets.
  EXPECT_THAT(documents("{\"a\": \"}\\\"}\",\n\"b\": 1}\n{}\n"),
              ElementsAre("{\"a\": \"}\\\"}\",\n\"b\": 1}\n", "{}\n"));
  // A YAML document may have braces within.
  EXPECT_THAT(documents("a: {b: 1}\nc: 2\n---\n"), ElementsAre("a: {b: 1}\nc: 2\n"));
}

TEST(ReadValue, KeepsWhatWasWritten) {
  const sample::WrittenValue value = read_value("v", "{a: 1, b: \"1\", c: [x, null], d: {}}");
  EXPECT_EQ(value.kind, Kind::kMap);
  EXPECT_THAT(value.keys, ElementsAre("a", "b", "c", "d"));
  EXPECT_FALSE(value.items[0].quoted);
  EXPECT_TRUE(value.items[1].quoted);
  EXPECT_EQ(value.items[2].items[0].text, "x");
  EXPECT_EQ(value.items[2].items[1].kind, Kind::kNothing);
  EXPECT_EQ(value.items[3].kind, Kind::kMap);
  // JSON's escapes, and no key twice.
  EXPECT_EQ(read_value("v", "\"a\\u0041\\n\\\"\"").text, "aA\n\"");
  EXPECT_THROW(read_value("v", "{a: 1, a: 2}"), config::Error);
  EXPECT_THROW(read_value("v", "{a: "), config::Error);
}

}  // namespace
}  // namespace scarab::topic
