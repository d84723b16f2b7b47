#include "common/sample/filter_tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "common/sample/error.hpp"

namespace scarab::sample {

namespace {

using Kind = FilterToken::Kind;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool continues_name(char c) {
  return begins_name(c) || is_digit(c) || c == '.' || c == '[' || c == ']';
}

class Lexer {
 public:
  explicit Lexer(const std::string& text) : text_(text) {}

  FilterToken next() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    begin_ = at_;
    if (at_ == text_.size()) return token(Kind::kEnd);
    const char c = text_[at_];
    if (begins_name(c)) return word();
    if (c == '\'') return quoted();
    const char after = peek(1);
    const bool sign = c == '-' || c == '+';
    if (is_digit(c) || ((sign || c == '.') && (is_digit(after) || after == '.'))) return number();
    return operator_sign();
  }

 private:
  char peek(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  FilterToken token(Kind kind) const {
    return {kind, text_.substr(begin_, at_ - begin_), begin_ + 1};
  }
  Error wrong(const std::string& reason) const { return Error(filter_error(begin_ + 1, reason)); }

  FilterToken word() {
    while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
    FilterToken out = token(Kind::kName);
    std::string capitals = out.text;
    std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    constexpr std::array<std::string_view, 7> kKeywords = {"AND",  "OR",   "NOT",  "BETWEEN",
                                                           "LIKE", "TRUE", "FALSE"};
    if (std::find(kKeywords.begin(), kKeywords.end(), capitals) == kKeywords.end()) return out;
    return {Kind::kKeyword, capitals, out.column};
  }

  FilterToken quoted() {
    std::string content;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] != '\'') {
        content += text_[at_];
      } else if (peek(1) == '\'') {  // a quote within the text is written twice, as in SQL
        content += text_[at_++];
      } else {
        ++at_;
        return {Kind::kText, content, begin_ + 1};
      }
    }
    throw wrong("text without its closing '");
  }

  /// Takes in what looks like one number, hexadecimal ones included; its reader says if it is none.
  FilterToken number() {
    if (text_[at_] == '-' || text_[at_] == '+') ++at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      const char before = text_[at_ - 1];
      const bool exponent_sign = (c == '-' || c == '+') && (before == 'e' || before == 'E');
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && !exponent_sign) break;
      ++at_;
    }
    return token(Kind::kNumber);
  }

  FilterToken operator_sign() {
    const std::string two = text_.substr(at_, 2);
    if (two == "==") throw wrong("equal is written =");
    if (two == "!=") throw wrong("not equal is written <>");
    if (two == "&&") throw wrong("and is written AND");
    if (two == "||") throw wrong("or is written OR");
    const char c = text_[at_];
    if (c == '"') throw wrong("text stands in single quotes");
    if (c == '!') throw wrong("not is written NOT");
    if (c == '%') throw wrong("a parameter has no value here; write the value itself");
    if (std::string_view("=<>()").find(c) == std::string_view::npos) {
      throw wrong(std::string("unexpected ") + c);
    }
    at_ += two == "<=" || two == ">=" || two == "<>" ? 2 : 1;
    return token(Kind::kOperator);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
};

}  // namespace

std::vector<FilterToken> filter_tokens(const std::string& expression) {
  Lexer lexer(expression);
  std::vector<FilterToken> tokens;
  do {
    tokens.push_back(lexer.next());
  } while (tokens.back().kind != Kind::kEnd);
  return tokens;
}

std::string filter_error(std::size_t column, const std::string& reason) {
  return "column " + std::to_string(column) + ": " + reason;
}

}  // namespace scarab::sample
