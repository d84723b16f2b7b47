#include "common/sample/quoted_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace scarab::sample {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// A character of UTF-8: so many bytes, or none of it.
struct Character {
  std::size_t size = 0;
  std::uint32_t code_point = 0;
};

/// The character at the beginning of the text (Unicode 15, table 3-7).
Character first_character(std::string_view text) {
  const unsigned lead = byte_at(text, 0);
  if (lead < 0x80) return {1, lead};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
  std::uint32_t code_point = lead & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte_at(text, i) & 0xC0U) != 0x80U) return {};
    code_point = code_point << 6U | (byte_at(text, i) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
  if (code_point < kLeast[size] || code_point > 0x10FFFF || is_surrogate) return {};
  return {size, code_point};
}

/// True for most of what text is made of: stands for itself, in one byte.
bool is_plain(char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; }

bool needs_escape(std::uint32_t code_point) {
  return code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0) || code_point == 0xFFFE ||
         code_point == 0xFFFF;
}

void append_escape(std::string& out, std::uint32_t code_point) {
  constexpr const char* kHex = "0123456789abcdef";
  out += "\\u";
  for (const unsigned shift : {12U, 8U, 4U, 0U}) out += kHex[code_point >> shift & 0xFU];
}

}  // namespace

void append_quoted(std::string& out, std::string_view text) {
  out += '"';
  while (true) {
    const auto plain = std::find_if_not(text.begin(), text.end(), is_plain) - text.begin();
    out += text.substr(0, static_cast<std::size_t>(plain));
    text.remove_prefix(static_cast<std::size_t>(plain));
    if (text.empty()) break;
    const Character next = first_character(text);
    if (next.size == 0) {
      out += kReplacement;
    } else if (needs_escape(next.code_point)) {
      append_escape(out, next.code_point);
    } else {
      if (next.size == 1) out += '\\';  // before a quote or a backslash
      out += text.substr(0, next.size);
    }
    text.remove_prefix(next.size == 0 ? 1 : next.size);
  }
  out += '"';
}

std::string character_text(char character) {
  const unsigned code_point = static_cast<unsigned char>(character);
  if (code_point < 0x80) return {character};
  return {static_cast<char>(0xC0U | code_point >> 6U),
          static_cast<char>(0x80U | (code_point & 0x3FU))};
}

}  // namespace scarab::sample
