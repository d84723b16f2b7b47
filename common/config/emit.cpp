#include "common/config/emit.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace scarab::config {
namespace {

using Kind = Value::Kind;

constexpr std::string_view kHexDigits = "0123456789abcdef";
/// Words that YAML or this layer give a meaning of their own.
constexpr std::array<std::string_view, 7> kSpecial = {"null",  "Null",   "NULL", "true",
                                                      "false", "absent", "nan"};

std::string escaped(unsigned char code) {
  return {'\\', 'x', kHexDigits[code >> 4], kHexDigits[code & 15]};
}

std::string in_double_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      result += {'\\', character};
    } else if (code < 0x20 || code == 0x7f) {
      result += escaped(code);
    } else {
      result += character;
    }
  }
  return result + "\"";
}

/// Words that are read as the same text with or without quotes.
bool needs_no_quotes(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_inner = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '+' || c == '-' || c == '.';
  };
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), is_inner) &&
         std::find(kSpecial.begin(), kSpecial.end(), text) == kSpecial.end();
}

std::string scalar_text(const Value& value) {
  if (value.kind == Kind::kNothing) return "null";
  return value.plain || needs_no_quotes(value.text) ? value.text : in_double_quotes(value.text);
}

bool is_nested(const Value& value) {
  return (value.kind == Kind::kMap || value.kind == Kind::kList) && !value.items.empty();
}

/// A list that fits on one line: of scalars.
bool is_flat_list(const Value& value) {
  return value.kind == Kind::kList &&
         std::none_of(value.items.begin(), value.items.end(), [](const Value& item) {
           return item.kind == Kind::kMap || item.kind == Kind::kList;
         });
}

std::string on_one_line(const Value& value) {
  if (value.kind == Kind::kMap) return "{}";
  if (value.kind != Kind::kList) return scalar_text(value);
  std::string result = "[";
  for (const Value& item : value.items) {
    if (result.size() > 1) result += ", ";
    result += scalar_text(item);
  }
  return result + "]";
}

void emit_block(const Value& value, std::size_t indent, std::string& out);

bool fits_one_line(const Value& value) { return !is_nested(value) || is_flat_list(value); }

void emit_map_item(const std::string& key, const Value& item, std::size_t indent,
                   std::string& out) {
  out += std::string(indent, ' ') + (needs_no_quotes(key) ? key : in_double_quotes(key)) + ":";
  if (fits_one_line(item)) {
    out += " " + on_one_line(item) + "\n";
  } else {
    out += "\n";
    emit_block(item, indent + 2, out);
  }
}

/// A nested item begins on the line of its dash.
void emit_list_item(const Value& item, std::size_t indent, std::string& out) {
  const std::size_t begin = out.size();
  if (fits_one_line(item)) {
    out += std::string(indent + 2, ' ') + on_one_line(item) + "\n";
  } else {
    emit_block(item, indent + 2, out);
  }
  out[begin + indent] = '-';
}

void emit_block(const Value& value, std::size_t indent, std::string& out) {
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    if (value.kind == Kind::kMap) {
      emit_map_item(value.keys[i].text, value.items[i], indent, out);
    } else {
      emit_list_item(value.items[i], indent, out);
    }
  }
}

}  // namespace

std::string emit(const Value& value) {
  if (fits_one_line(value)) return on_one_line(value) + "\n";
  std::string out;
  emit_block(value, 0, out);
  return out;
}

}  // namespace scarab::config
