#include "tools/log/replay/base64.hpp"

#include <string_view>

#include "common/bus/error.hpp"

namespace scarab::log {

sample::Bytes base64_bytes(const std::string& text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr unsigned kBitsOfDigit = 6;
  constexpr unsigned kBitsOfByte = 8;
  sample::Bytes bytes;
  unsigned bits = 0;
  unsigned held = 0;  // bits not yet handed on
  for (const char c : std::string_view(text).substr(0, text.find('='))) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) throw bus::Error("text that is no base64");
    bits = (bits << kBitsOfDigit) | static_cast<unsigned>(digit);
    held += kBitsOfDigit;
    if (held < kBitsOfByte) continue;
    held -= kBitsOfByte;
    bytes.push_back(static_cast<std::byte>(bits >> held));
    bits &= (1U << held) - 1;
  }
  return bytes;
}

}  // namespace scarab::log
