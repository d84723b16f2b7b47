#include "common/sample/written_number.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <type_traits>

#include "common/sample/error.hpp"
#include "common/sample/idl_text.hpp"

namespace scarab::sample {

namespace {

using Kind = WrittenValue::Kind;

std::string type_name(Primitive primitive) { return idl_type_name(Type{primitive}); }

std::string shown(const WrittenValue& value) {
  if (value.kind == Kind::kList) return "a list";
  if (value.kind == Kind::kMap) return "a map";
  return value.quoted ? "'" + value.text + "'" : value.text;
}

template <class Integer>
Integer read_integer(Primitive primitive, const WrittenValue& value) {
  if (value.kind == Kind::kNothing) return 0;
  std::string_view digits = value.text;
  const bool hexadecimal = digits.substr(0, 2) == "0x";
  if (hexadecimal) digits.remove_prefix(2);
  // Wider than an octet, which from_chars would read as a character.
  std::conditional_t<sizeof(Integer) == 1, std::int32_t, Integer> number = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, number, hexadecimal ? 16 : 10);
  using Limits = std::numeric_limits<Integer>;
  const bool fits = number >= Limits::min() && number <= Limits::max();
  if (value.kind != Kind::kText || value.quoted || stop != end || error != std::errc{} || !fits) {
    throw Error(shown(value) + " is no " + type_name(primitive) + " (" +
                std::to_string(Limits::min()) + " to " + std::to_string(Limits::max()) + ")");
  }
  return static_cast<Integer>(number);
}

template <class Float>
Float read_float(Primitive primitive, const WrittenValue& value) {
  if (value.kind == Kind::kNothing) return 0;
  std::string_view text = value.text;
  const bool negative = text.substr(0, 1) == "-";
  if (negative) text.remove_prefix(1);
  if (text == "nan" || text == ".nan" || text == "NaN") {
    return std::numeric_limits<Float>::quiet_NaN();
  }
  if (text == "inf" || text == ".inf" || text == "Infinity") {
    return negative ? -std::numeric_limits<Float>::infinity()
                    : std::numeric_limits<Float>::infinity();
  }
  Float number = 0;
  const char* end = value.text.data() + value.text.size();
  const auto [stop, error] = std::from_chars(value.text.data(), end, number);
  if (error == std::errc::result_out_of_range) {
    throw Error(shown(value) + " is beyond a " + type_name(primitive));
  }
  // from_chars also takes "infinity" and the like; those are written as above.
  const bool is_number = error == std::errc{} && stop == end && std::isfinite(number);
  if (value.kind != Kind::kText || value.quoted || !is_number) {
    throw Error(shown(value) + " is no number");
  }
  return number;
}

bool read_truth(const WrittenValue& value) {
  if (value.kind == Kind::kNothing) return false;
  const bool is_truth = value.text == "true" || value.text == "false";
  if (value.kind != Kind::kText || value.quoted || !is_truth) {
    throw Error(shown(value) + " is neither true nor false");
  }
  return value.text == "true";
}

char read_character(const WrittenValue& value) {
  if (value.kind == Kind::kNothing) return '\0';
  if (value.kind != Kind::kText || value.text.size() != 1) {
    throw Error(shown(value) + " is no single character of 8 bits");
  }
  return value.text[0];
}

}  // namespace

void write_primitive(Primitive primitive, const WrittenValue& value, CdrOutput& out) {
  switch (primitive) {
    case Primitive::kBoolean:
      return out.write(static_cast<std::uint8_t>(read_truth(value)));
    case Primitive::kOctet:
      return out.write(read_integer<std::uint8_t>(primitive, value));
    case Primitive::kChar:
      return out.write(read_character(value));
    case Primitive::kInt8:
      return out.write(read_integer<std::int8_t>(primitive, value));
    case Primitive::kInt16:
      return out.write(read_integer<std::int16_t>(primitive, value));
    case Primitive::kInt32:
      return out.write(read_integer<std::int32_t>(primitive, value));
    case Primitive::kInt64:
      return out.write(read_integer<std::int64_t>(primitive, value));
    case Primitive::kUint16:
      return out.write(read_integer<std::uint16_t>(primitive, value));
    case Primitive::kUint32:
      return out.write(read_integer<std::uint32_t>(primitive, value));
    case Primitive::kUint64:
      return out.write(read_integer<std::uint64_t>(primitive, value));
    case Primitive::kFloat:
      return out.write(read_float<float>(primitive, value));
    case Primitive::kDouble:
      return out.write(read_float<double>(primitive, value));
  }
}

std::int32_t enum_number(const EnumType& type, const WrittenValue& value) {
  if (value.kind == Kind::kNothing) {
    const bool has_zero = type.name_of(0) != nullptr || type.literals.empty();
    return has_zero ? 0 : type.literals.front().value;
  }
  std::string names;
  for (const Literal& literal : type.literals) {
    const bool by_number = !value.quoted && std::to_string(literal.value) == value.text;
    if (value.kind == Kind::kText && (literal.name == value.text || by_number)) {
      return literal.value;
    }
    names += (names.empty() ? "" : ", ") + literal.name;
  }
  throw Error(shown(value) + " is no " + type.name + "; there are " + names);
}

}  // namespace scarab::sample
