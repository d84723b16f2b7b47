#include "tools/log/hex_text.hpp"

namespace scarab::log {

void append_hex(std::string& out, sample::ByteView bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  out += '"';
  for (std::size_t i = 0; i < bytes.size; ++i) {
    const auto byte = std::to_integer<unsigned>(bytes.data[i]);
    out += kDigits[byte >> 4U];
    out += kDigits[byte & 0xFU];
  }
  out += '"';
}

}  // namespace scarab::log
