#include "common/sample/filter_operand.hpp"

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "common/sample/idl_text.hpp"

namespace scarab::sample {

namespace {

using Kind = FilterToken::Kind;

Error wrong(const WrittenOperand& at, const std::string& reason) {
  return Error(filter_error(at.token.column, reason));
}

/// What values a field has: only equal kinds compare.
enum class Family { kNumber, kTruth, kText, kEnum };

Family family_of(const FieldPath& path) {
  if (path.is_length()) return Family::kNumber;
  const Type& type = resolve(*path.type());
  if (std::holds_alternative<StringType>(type.kind)) return Family::kText;
  if (std::holds_alternative<EnumType>(type.kind)) return Family::kEnum;
  const Primitive primitive = std::get<Primitive>(type.kind);
  if (primitive == Primitive::kBoolean) return Family::kTruth;
  return primitive == Primitive::kChar ? Family::kText : Family::kNumber;
}

std::string description(const FieldPath& path) {
  return path.text() + " is " +
         (path.is_length() ? "a number" : "of type " + idl_type_name(*path.type()));
}

bool is_float(const FieldPath& path) {
  const auto* primitive = std::get_if<Primitive>(&resolve(*path.type()).kind);
  return !path.is_length() && primitive != nullptr && *primitive == Primitive::kFloat;
}

template <class Integer>
std::optional<long double> integer(std::string_view text) {
  if (text.substr(0, 1) == "+") text.remove_prefix(1);
  const bool hexadecimal = text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X";
  if (hexadecimal) text.remove_prefix(2);
  Integer value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, hexadecimal ? 16 : 10);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return static_cast<long double>(value);
}

long double number(const WrittenOperand& written, const FieldPath& beside) {
  const std::string& text = written.token.text;
  if (const auto value = integer<std::int64_t>(text)) return *value;
  if (const auto value = integer<std::uint64_t>(text)) return *value;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size()) throw wrong(written, text + " is no number");
  return is_float(beside) ? static_cast<long double>(static_cast<float>(value)) : value;
}

long double enum_value(const WrittenOperand& written, const FieldPath& beside) {
  const auto& type = std::get<EnumType>(resolve(*beside.type()).kind);
  if (written.token.kind == Kind::kNumber) return number(written, beside);
  std::string names;
  for (const Literal& literal : type.literals) {
    if (literal.name == written.token.text) return literal.value;
    names += (names.empty() ? "" : ", ") + literal.name;
  }
  throw wrong(written, "'" + written.token.text + "' is no " + type.name + "; there are " + names);
}

FilterValue value_beside(const WrittenOperand& written, const FieldPath& field) {
  const Kind kind = written.token.kind;
  const Family family = family_of(field);
  const bool is_truth = kind == Kind::kKeyword;
  if (family == Family::kNumber && kind == Kind::kNumber) return number(written, field);
  if (family == Family::kEnum && !is_truth) return enum_value(written, field);
  if (family == Family::kText && kind == Kind::kText) return written.token.text;
  if (family == Family::kTruth && is_truth) return written.token.text == "TRUE" ? 1.0L : 0.0L;
  const char* expected = family == Family::kNumber  ? "a number"
                         : family == Family::kTruth ? "TRUE or FALSE"
                         : family == Family::kText  ? "text in single quotes"
                                                    : "the name of a value in single quotes";
  throw wrong(written, description(field) + ": " + expected + " expected");
}

}  // namespace

FilterOperand meant_beside(const WrittenOperand& written, const WrittenOperand& other) {
  if (written.path == nullptr && other.path == nullptr) {
    throw wrong(written, "a comparison needs a field");
  }
  if (written.path == nullptr) return {std::nullopt, value_beside(written, *other.path)};
  if (other.path != nullptr && family_of(*written.path) != family_of(*other.path)) {
    throw wrong(other, description(*other.path) + ", but " + description(*written.path));
  }
  return {written.field, {}};
}

}  // namespace scarab::sample
