#include "common/config/scalar.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include "common/config/error.hpp"

namespace scarab::config {
namespace {

bool is_digit(char character) { return character >= '0' && character <= '9'; }

std::string without_plus(const std::string& text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && (is_digit(text[1]) || text[1] == '.');
  return has_plus ? text.substr(1) : text;
}

bool has_leading_zero(const std::string& text) {
  const std::size_t first = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  return text.size() > first + 1 && text[first] == '0' && is_digit(text[first + 1]);
}

bool is_not_finite(const std::string& text) {
  std::string word;
  for (const char character : text) {
    word +=
        character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
  }
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
  if (!word.empty() && word[0] == '.') word.erase(0, 1);
  return word == "nan" || word == "inf" || word == "infinity";
}

/// What is wrong with a text of any kind of number, before its digits are looked at.
std::string refusal(const std::string& text) {
  if (has_leading_zero(text)) {
    return in_quotes(text) + " has a leading zero, which YAML reads as octal; write it without";
  }
  if (is_not_finite(text)) return in_quotes(text) + " is not finite";
  return {};
}

template <class T>
Parsed<T> parse(const std::string& text, const char* expected) {
  if (std::string reason = refusal(text); !reason.empty()) return {std::nullopt, std::move(reason)};
  const std::string digits = without_plus(text);
  T value{};
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && rest == end) {
    return {std::nullopt, in_quotes(text) + " is beyond what the type can hold"};
  }
  if (error != std::errc{} || rest != end) {
    return {std::nullopt, std::string("expected ") + expected + ", found " + in_quotes(text)};
  }
  return {value, {}};
}

}  // namespace

Parsed<double> parse_number(const std::string& text) {
  Parsed<double> parsed = parse<double>(text, "a number");
  // std::from_chars also knows spellings such as nan(1).
  if (parsed.value && !std::isfinite(*parsed.value))
    return {std::nullopt, in_quotes(text) + " is not finite"};
  return parsed;
}

Parsed<long long> parse_signed(const std::string& text) {
  return parse<long long>(text, "a whole number");
}

Parsed<unsigned long long> parse_unsigned(const std::string& text) {
  if (const auto negative = parse_signed(text).value; negative && *negative < 0) {
    return {std::nullopt, text + " is negative"};
  }
  return parse<unsigned long long>(text, "a whole number");
}

std::string format_number(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

}  // namespace scarab::config
