#include "common/config/json.hpp"

#include <cstddef>
#include <string_view>

#include "common/config/scalar.hpp"

namespace scarab::config {
namespace {

using Kind = Value::Kind;

constexpr std::size_t kLineLength = 120;

std::string scalar_text(const Value& value) {
  if (value.kind == Kind::kNothing) return "null";
  const bool truth = value.text == "true" || value.text == "false";
  const bool bare = value.plain && (truth || parse_number(value.text).value);
  return bare ? value.text : in_json_quotes(value.text);
}

std::string label(const Value& value, std::size_t i) {
  return value.kind == Kind::kMap ? in_json_quotes(value.keys[i].text) + ": " : "";
}

std::string on_one_line(const Value& value) {
  if (value.kind != Kind::kMap && value.kind != Kind::kList) return scalar_text(value);
  std::string result = value.kind == Kind::kMap ? "{" : "[";
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    if (i > 0) result += ", ";
    result += label(value, i) + on_one_line(value.items[i]);
  }
  return result + (value.kind == Kind::kMap ? "}" : "]");
}

/// `column` characters of the line, with what follows the value on it, are taken.
void emit(const Value& value, std::size_t indent, std::size_t column, std::string& out) {
  const std::string line = on_one_line(value);
  if (column + line.size() <= kLineLength || value.items.empty()) {
    out += line;
    return;
  }
  const std::string margin(indent + 2, ' ');
  out += value.kind == Kind::kMap ? "{" : "[";
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    const std::string start = margin + label(value, i);
    out += (i > 0 ? ",\n" : "\n") + start;
    emit(value.items[i], indent + 2, start.size() + 1, out);
  }
  out += "\n" + std::string(indent, ' ') + (value.kind == Kind::kMap ? "}" : "]");
}

}  // namespace

std::string in_json_quotes(std::string_view text) {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::string result = "\"";
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      result += {'\\', character};
    } else if (code < 0x20) {
      result += {'\\', 'u', '0', '0', kHexDigits[code >> 4], kHexDigits[code & 15]};
    } else {
      result += character;
    }
  }
  return result + "\"";
}

std::string emit_json(const Value& value) {
  std::string out;
  emit(value, 0, 0, out);
  return out + "\n";
}

}  // namespace scarab::config
