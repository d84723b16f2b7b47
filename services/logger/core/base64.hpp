#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace scarab::logger {

/// Bytes as text (RFC 4648, section 4), padded with `=`.
std::string base64(const std::uint8_t* bytes, std::size_t size);

}  // namespace scarab::logger
