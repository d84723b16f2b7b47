#include "common/sample/idl_lexer.hpp"

#include <utility>

#include "common/sample/error.hpp"

namespace scarab::sample {

namespace {

// Not <cctype>: what a letter is must not depend on the locale.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

class Lexer {
 public:
  explicit Lexer(std::string_view idl) : idl_(idl) {}

  std::vector<IdlToken> run() {
    while (skip_to_token()) next();
    tokens_.push_back({IdlToken::Kind::kEnd, "", line_});
    return std::move(tokens_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error("line " + std::to_string(line_) + ": " + what);
  }

  char at(std::size_t ahead = 0) const {
    return at_ + ahead < idl_.size() ? idl_[at_ + ahead] : '\0';
  }
  bool more() const { return at_ < idl_.size(); }

  void advance() {
    if (idl_[at_] == '\n') ++line_;
    ++at_;
  }

  /// False at the end of the text.
  bool skip_to_token() {
    while (more()) {
      if (is_blank(at())) {
        advance();
      } else if (at() == '#' || (at() == '/' && at(1) == '/')) {
        while (more() && at() != '\n') advance();
      } else if (at() == '/' && at(1) == '*') {
        skip_comment();
      } else {
        return true;
      }
    }
    return false;
  }

  void skip_comment() {
    const std::size_t end = idl_.find("*/", at_ + 2);
    if (end == std::string_view::npos) fail("a comment without end");
    while (at_ < end + 2) advance();
  }

  void next() {
    if (is_letter(at())) {
      take(IdlToken::Kind::kWord, [&] { return is_letter(at()) || is_digit(at()); });
    } else if (is_digit(at()) || (at() == '.' && is_digit(at(1)))) {
      take(IdlToken::Kind::kNumber, [&] {
        const bool is_sign = at() == '+' || at() == '-';
        const char before = idl_[at_ - 1];
        return is_letter(at()) || is_digit(at()) || at() == '.' ||
               (is_sign && is_decimal_ && (before == 'e' || before == 'E'));
      });
    } else if (at() == '"' || at() == '\'') {
      literal(at());
    } else {
      symbol();
    }
  }

  template <class Belongs>
  void take(IdlToken::Kind kind, Belongs&& belongs) {
    is_decimal_ = !(at() == '0' && (at(1) == 'x' || at(1) == 'X'));
    const std::size_t first = at_++;
    while (more() && belongs()) ++at_;
    tokens_.push_back({kind, std::string(idl_.substr(first, at_ - first)), line_});
  }

  void literal(char quote) {
    const std::size_t first = at_++;
    while (more() && at() != quote && at() != '\n') at_ += at() == '\\' ? 2 : 1;
    if (at() != quote) fail("a literal without end");
    ++at_;
    tokens_.push_back(
        {IdlToken::Kind::kLiteral, std::string(idl_.substr(first, at_ - first)), line_});
  }

  void symbol() {
    constexpr std::string_view kSymbols = "{}()<>[];,:=@+-*/%|&^~";
    if (kSymbols.find(at()) == std::string_view::npos || at() == '\0') {
      fail("a character that IDL does not have");
    }
    const std::size_t size = at() == ':' && at(1) == ':' ? 2 : 1;
    tokens_.push_back({IdlToken::Kind::kSymbol, std::string(idl_.substr(at_, size)), line_});
    at_ += size;
  }

  std::string_view idl_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  bool is_decimal_ = true;
  std::vector<IdlToken> tokens_;
};

}  // namespace

std::vector<IdlToken> idl_tokens(std::string_view idl) { return Lexer(idl).run(); }

}  // namespace scarab::sample
