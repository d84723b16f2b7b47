#include "common/config/document.hpp"

#include <gtest/gtest.h>

#include <string>

namespace scarab::config {
namespace {

std::string error_of(const std::string& text) {
  try {
    (void)parse_text("x.yaml", text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Document, KeepsOrderTextQuotesAndPositions) {
  const Document document = parse_text("x.yaml", "# comment\nb: 010\na:\n  - 'x'\n  -\n");
  const Value& root = document.root;
  ASSERT_EQ(root.kind, Value::Kind::kMap);
  ASSERT_EQ(root.keys.size(), 2U);
  EXPECT_EQ(root.keys[0].text, "b");
  EXPECT_EQ(root.keys[1].text, "a");
  EXPECT_EQ(root.keys[1].position.line, 3);
  EXPECT_EQ(root.items[0].text, "010") << "not interpreted";
  EXPECT_TRUE(root.items[0].plain);
  EXPECT_EQ(root.items[0].position.line, 2);
  EXPECT_EQ(root.items[0].position.column, 4);
  const Value& list = root.items[1];
  ASSERT_EQ(list.items.size(), 2U);
  EXPECT_FALSE(list.items[0].plain);
  EXPECT_EQ(list.items[0].position.line, 4);
  EXPECT_EQ(list.items[1].kind, Value::Kind::kNothing);
}

TEST(Document, OfNothingIsNothing) {
  EXPECT_EQ(parse_text("x.yaml", "").root.kind, Value::Kind::kNothing);
  EXPECT_EQ(parse_text("x.yaml", "# only a comment\n").root.kind, Value::Kind::kNothing);
}

TEST(Document, TakesFilesFromOtherEditors) {
  const Document document = parse_text("x.yaml",
                                       "\xef\xbb\xbf"
                                       "a: 1\r\nb: [2,\r\n 3]\r\n");
  ASSERT_EQ(document.root.keys.size(), 2U);
  EXPECT_EQ(document.root.keys[0].text, "a");
  EXPECT_EQ(document.root.items[0].text, "1");
  EXPECT_EQ(document.root.keys[1].position.line, 2);
  EXPECT_EQ(document.root.items[1].items.size(), 2U);
}

TEST(Document, RefusesASecondDocument) {
  EXPECT_EQ(error_of("a: 1\n---\nb: 2\n"),
            "x.yaml:1:1: (syntax): more than one document in the file");
}

TEST(Document, RefusesAliases) {
  EXPECT_EQ(error_of("a: &x 1\nb: *x\n"),
            "x.yaml:1:4: a: anchors are not supported; write the value out");
}

TEST(Document, RefusesNullKeys) {
  EXPECT_EQ(error_of("~: 1\n"), "x.yaml:1:1: (top level): a key must be text");
}

TEST(Document, SurvivesDeepNesting) {
  EXPECT_NE(error_of(std::string(100'000, '[')), "no error");
  EXPECT_NE(error_of(std::string(100'000, '{')), "no error");
}

TEST(Error, IsOneLineWhateverTheFileHolds) {
  const Error error("a\nb", {3, 4}, "k\ty", "r\x01");
  EXPECT_STREQ(error.what(), "a?b:3:4: k?y: r?");
}

}  // namespace
}  // namespace scarab::config
