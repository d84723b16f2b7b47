#include "common/sample/idl_cursor.hpp"

#include "common/sample/error.hpp"

namespace scarab::sample {

namespace {

constexpr std::size_t kMostLevels = 64;

}  // namespace

bool IdlCursor::sees(const char* text) const {
  return peek().text == text && peek().kind != IdlToken::Kind::kLiteral;
}

std::string IdlCursor::seen() const {
  return is_end() ? "the end of the text" : "'" + peek().text + "'";
}

IdlToken IdlCursor::take() {
  const IdlToken& token = peek();
  if (!is_end()) ++at_;
  return token;
}

bool IdlCursor::accept(const char* text) {
  if (!sees(text)) return false;
  take();
  return true;
}

void IdlCursor::expect(const char* text) {
  if (!accept(text)) fail("expected '" + std::string(text) + "', found " + seen());
}

std::string IdlCursor::identifier() {
  if (peek().kind != IdlToken::Kind::kWord) fail("expected a name, found " + seen());
  std::string name = take().text;
  if (name.size() > 1 && name.front() == '_') name.erase(0, 1);
  return name;
}

std::string IdlCursor::scoped_name() {
  std::string name = accept("::") ? "::" : "";
  name += identifier();
  while (accept("::")) name += "::" + identifier();
  return name;
}

void IdlCursor::skip_group(const char* open, const char* close) {
  for (std::size_t depth = 1; depth > 0;) {
    if (is_end()) fail(std::string("'") + open + "' without '" + close + "'");
    if (sees(open)) ++depth;
    if (sees(close)) --depth;
    take();
  }
}

void IdlCursor::fail(const std::string& what) const {
  throw Error("line " + std::to_string(peek().line) + ": " + what);
}

IdlCursor::Level::Level(IdlCursor& cursor) : cursor_(cursor) {
  if (cursor.levels_ == kMostLevels) cursor.fail("nested too deep");
  ++cursor.levels_;
}

}  // namespace scarab::sample
