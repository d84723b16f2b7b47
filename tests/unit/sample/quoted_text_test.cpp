#include "common/sample/quoted_text.hpp"

#include <gtest/gtest.h>

namespace scarab::sample {
namespace {

std::string quoted(std::string_view text) {
  std::string out = "x: ";
  append_quoted(out, text);
  return out.substr(3);
}

TEST(QuotedText, LeavesWhatReadersTakeAsItIs) {
  EXPECT_EQ(quoted(""), R"("")");
  EXPECT_EQ(quoted("a b/c'd"), R"("a b/c'd")");
  const std::string_view text = "\xC3\xA4 \xE2\x82\xAC \xF0\x9F\xA6\x97 \xED\x9F\xBF";
  EXPECT_EQ(quoted(text), '"' + std::string(text) + '"');
}

TEST(QuotedText, EscapesWhatTheyDoNot) {
  EXPECT_EQ(quoted("\"\\"), R"("\"\\")");
  EXPECT_EQ(quoted({"\0\n\x1F\x7F", 4}), R"("\u0000\u000a\u001f\u007f")");
  EXPECT_EQ(quoted("\xC2\x85\xEF\xBF\xBE\xEF\xBF\xBF"), R"("\u0085\ufffe\uffff")");
}

TEST(QuotedText, ReplacesEveryByteThatIsNoUtf8) {
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(quoted("a\xE4z"), "\"a" + bad + "z\"");        // Latin-1
  EXPECT_EQ(quoted("\xC3"), "\"" + bad + "\"");            // cut
  EXPECT_EQ(quoted("\xC0\xAF"), "\"" + bad + bad + "\"");  // longer than need be
  EXPECT_EQ(quoted("\xE0\x80\x80"), "\"" + bad + bad + bad + "\"");
  EXPECT_EQ(quoted("\xED\xA0\x80"), "\"" + bad + bad + bad + "\"");  // half a surrogate pair
  EXPECT_EQ(quoted("\xF4\x90\x80\x80"), "\"" + bad + bad + bad + bad + "\"");
}

TEST(CharacterText, IsUtf8OfLatin1) {
  EXPECT_EQ(character_text('a'), "a");
  EXPECT_EQ(character_text('\xE4'), "\xC3\xA4");
  EXPECT_EQ(character_text('\x80'), "\xC2\x80");
  EXPECT_EQ(character_text('\0'), std::string(1, '\0'));
}

}  // namespace
}  // namespace scarab::sample
